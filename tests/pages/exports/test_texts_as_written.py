"""Texts that a format would read in its own way, or cannot hold: written otherwise, or named."""

from __future__ import annotations

from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.pages.classroom.gift import gift
from sim.pages.classroom.losses import fitting, losses
from sim.pages.classroom.moodle import moodle_xml
from sim.pages.classroom.portable import Portable
from sim.pages.classroom.qti.mathml import formulas_by
from sim.pages.classroom.qti.package import qti_package
from sim.pages.site.carried import node_modules
from sim.pages.text.formulas import KATEX
from tests.conftest import ROOT
from tests.pages.given.exported import from_gift
from tests.pages.given.qti_rules import ITEM, MATH, mistakes
from tests.pages.given.zipped import in_zip

FORMULA = r'<span class="arithmatex">\(v_A &lt; \frac{1}{2}\)</span>'
BROKEN = r'<span class="arithmatex">\(\frac{\)</span>'
FORMULAS = formulas_by(node_modules(ROOT) / KATEX)


def one(shape: str, **more: object) -> Portable:
    return Portable(id="q", shape=shape, ask="?", marks=1, **more)  # type: ignore[arg-type]


@pytest.mark.parametrize("right", [0, 1])
def test_a_percentage_at_the_beginning_of_an_answer_is_no_weight_in_gift(right: int) -> None:
    texts = ("%50% of the speed", "half")
    answers = tuple((text, 100.0 * (k == right), "") for k, text in enumerate(texts))
    made = gift("T", [one("choice", answers=answers)])
    # Of a choice after “=” no weight is read, of one after “~” it is.
    assert ("\n=%50% of the speed" if right == 0 else "\n~%0%%50% of the speed") in made
    short = gift("T", [one("short", answers=(("%50%", 100.0, ""),))])
    assert from_gift(short)[0]["answers"] == [("%50%", 100.0, "")]
    assert "\n=%100%%50%" in short


@pytest.mark.parametrize("word", ["html", "plain", "moodle", "markdown"])
def test_a_word_in_brackets_at_the_beginning_of_an_answer_is_no_format_in_gift(word: str) -> None:
    text = f"[{word}] a"
    made = gift("T", [one("choice", answers=((text, 100.0, text), ("b", 0.0, "")))])
    ((right, _, _), _) = from_gift(made)[0]["answers"]  # type: ignore[misc]
    assert not right.startswith("[") and unescape(right) == text
    short = gift("T", [one("short", answers=((text, 100.0, ""),))])
    assert f"\n=[plain]{text}" in short  # one is taken away, as typed it stays


def test_a_line_that_moodles_lists_cannot_hold_is_named_and_its_question_left_out() -> None:
    fits = one("pairs", pairs=(("1.", "<b>a</b>" + "&amp;" * 254), ("2.", "b")))
    long = one("pairs", pairs=(("1.", "a"), ("2.", "b" * 256)), order=("a", "b" * 256))
    other = one("pairs", pairs=(("1.", "a"), ("2.", "b")), others=("c" * 256,))
    for target in ("moodle", "gift"):
        taken, refused = fitting([fits, long, other], target)  # type: ignore[arg-type]
        assert taken == [fits]
        assert refused == ["q: Moodle's lists hold 255 letters; a line has more"] * 2
    assert fitting([fits, long, other], "qti") == ([fits, long, other], [])


def test_a_title_of_any_length_and_lines_is_a_category_that_moodle_can_hold() -> None:
    title = "A/B\n\n" + "word " * 60
    name = ElementTree.fromstring(moodle_xml(title, [])).findtext("question/category/text") or ""
    path = "$course$/top/"
    assert name.startswith(f"{path}A//B word word")
    assert len(name.removeprefix(path).replace("//", "/")) <= 255
    assert gift(title, []) == f"$CATEGORY: {name}\n"


def test_pictures_lie_in_moodles_file_beside_the_text_that_shows_them() -> None:
    picture = '<img alt="c" src="one/my%20cart.png" />'
    web = '<img alt="w" src="https://a.example/b.png" />'
    q = one("choice", explain=web, answers=((picture, 100.0, f"{picture}{picture}"), ("b", 0, "")))
    held = {"one/my%20cart.png": b"cart"}
    made = moodle_xml("T", [q], held.get)
    (answer, *_) = ElementTree.fromstring(made).iter("answer")
    for place, times in ((answer, 1), (answer.find("feedback"), 2)):
        assert place is not None
        (file,) = place.findall("file")
        assert (file.get("path"), file.get("encoding"), file.text) == ("/", "base64", "Y2FydA==")
        shown = f'src="@@PLUGINFILE@@/{file.get("name")}"'
        assert (place.findtext("text") or "").count(shown) == times
    assert 'src="https://a.example/b.png"' in made
    said = ["q: its pictures are not in the file; add them on the platform"]
    assert losses([q], "moodle", held.get) == said  # that of another site is in no file
    assert losses([one("choice", answers=q.answers)], "moodle", held.get) == []
    assert losses([one("choice", answers=q.answers)], "gift", held.get) == said
    words = "q: of a picture in a list to choose from, its words are there"
    assert losses([one("pairs", pairs=(("a", picture),))], "moodle", held.get) == [words]


def test_formulas_in_a_list_to_choose_from_are_named_as_lost() -> None:
    paired = one("pairs", pairs=((FORMULA, "a"), ("b", "c")), others=(FORMULA,))
    said = ["q: formulas in a list to choose from stand there as they are typed"]
    assert losses([paired], "moodle") == losses([paired], "gift") == said
    assert losses([one("pairs", pairs=((FORMULA, "a"),))], "moodle") == []  # Moodle draws it
    assert losses([paired], "qti", formulas=FORMULAS) == []


def test_a_formula_is_drawn_by_any_player_of_qti_and_one_with_a_mistake_is_named() -> None:
    block = r'<div class="arithmatex">\[a = b\]</div>'
    answers = ((FORMULA, 100.0, FORMULA), (BROKEN, 0.0, ""))
    q = one("choice", explain=block, answers=answers)
    files = in_zip(qti_package("T", [q], formulas=FORMULAS, name="t"))
    item = ElementTree.fromstring(files["items/q.xml"])
    assert mistakes(item) == []
    right, wrong = item.iter(f"{{{ITEM}}}qti-simple-choice")
    (math,) = right.iter(MATH)
    assert "".join(math.itertext()) == "vA<12"
    assert r"\frac" in "".join(wrong.itertext())
    assert [m.get("display") for m in item.iter(MATH)] == [None, None, "block"]
    said = ["q: its formulas stand there as they are typed"]
    assert losses([q], "qti", formulas=FORMULAS) == said
    assert losses([one("choice", answers=answers[:1])], "qti", formulas=FORMULAS) == []
    assert losses([one("choice", answers=answers[:1])], "qti") == said  # where none can be drawn


def test_a_bank_is_exported_in_the_language_of_its_catalogue(tmp_path: Path) -> None:
    out = tmp_path / "a.zip"
    bank = str(ROOT / "worksheets" / "banks" / "forces-and-motion.yml")
    words = ["export", bank, "--to", "qti", "--language", "ta", "--out", str(out)]
    result = CliRunner().invoke(main, words)
    assert result.exit_code == 0, result.output
    item = in_zip(out.read_bytes())["items/lamp.xml"].decode()
    assert 'xml:lang="ta"' in item and "விசை" in item


def test_a_bank_without_a_catalogue_says_so(tmp_path: Path, monkeypatch) -> None:
    bank = tmp_path / "worksheets" / "banks" / "a.yml"
    bank.parent.mkdir(parents=True)
    bank.write_text("title: T\nitems:\n  - {id: a, type: long, ask: Q?}\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    words = ["export", "worksheets/banks/a.yml", "--language", "ta"]
    result = CliRunner().invoke(main, words)
    assert result.exit_code == 2 and "no catalogue in “ta”" in result.stderr
