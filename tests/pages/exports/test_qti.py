"""QTI 3.0: a package of the right build, whose items give the marks and feedback of the pages.

Marks are checked by a small reader of response processing (`qti_platform`), which follows the model
and not our writer; elements, attributes and values by rules of their own (`qti_rules`).
"""

from __future__ import annotations

import io
import itertools
import zipfile
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.lesson.bank import Bank, read_bank
from sim.lesson.question import Question
from sim.pages.classroom.gift import gift
from sim.pages.classroom.losses import losses
from sim.pages.classroom.moodle import moodle_xml
from sim.pages.classroom.portable import Portable, portable
from sim.pages.classroom.qti.package import qti_package
from sim.pages.classroom.qti.xhtml import blocks, flow
from tests.pages.given.banks import OWN, read
from tests.pages.given.qti_platform import Platform
from tests.pages.given.qti_rules import ITEM, LANG, NAME, PACKAGE, local, mistakes
from tests.pages.given.zipped import in_zip

ROOT = Path(__file__).parents[3]
GOLDEN = ROOT / "tests" / "golden" / "exports" / "every-kind.yml"


def more() -> Bank:
    """What the other two have not: known wrong numbers, tables, pictures, odd characters."""
    return read_bank({"title": "Ärger & Mehr", "items": [
        {"id": "speed", "type": "number", "ask": "How | fast?\n\n| a | b |\n|---|---|\n| 1 | 2 |",
         "answer": "0.3 m/s", "tolerance": "0.01 m/s", "marks": 2, "explain": "So.", "sure": True,
         "wrong": [{"value": "0.32 m/s", "feedback": "Near & <wrong>"},
                   {"value": "-0.3 m/s", "tolerance": "0.05 m/s", "feedback": "The *other* way"},
                   {"value": "0 m/s"}]},
        {"id": "pic", "type": "single", "ask": "See ![carts](a.svg) &nbsp; é\x07\ufffe",
         "options": [{"text": "- a\n- b", "correct": True}, "`x < 1`"]},
        {"id": "pairs", "type": "matching", "ask": "Match?",
         "pairs": [{"left": "1", "right": "a"}, {"left": "2", "right": "b"}]},
    ]})  # fmt: skip


BANKS = {"every-kind": read(GOLDEN), "own": read(OWN), "more": more()}


def unpacked(bank: Bank) -> dict[str, bytes]:
    taken, _ = portable(bank.items.values())
    return in_zip(qti_package(bank.title, taken, name="bank"))


@pytest.mark.parametrize("name", BANKS)
def test_every_file_keeps_the_rules_of_the_model(name: str) -> None:
    for path, content in unpacked(BANKS[name]).items():
        root = ElementTree.fromstring(content)
        if path != "imsmanifest.xml":
            assert root.tag.startswith(f"{{{ITEM}}}")
            assert mistakes(root) == [], path


@pytest.mark.parametrize("name", BANKS)
def test_the_manifest_names_every_file_once_and_nothing_else(name: str) -> None:
    files = unpacked(BANKS[name])
    root = ElementTree.fromstring(files["imsmanifest.xml"])
    assert [local(part) for part in root] == ["metadata", "organizations", "resources"]
    names = [node.get("identifier") for node in root.iter() if node.get("identifier")]
    assert len(names) == len(set(names)) and all(NAME.fullmatch(str(one)) for one in names)
    places = {"p": PACKAGE}
    assert root.findtext("p:metadata/p:schema", "", places) == "QTI Package"
    assert root.findtext("p:metadata/p:schemaversion", "", places) == "3.0.0"
    resources = root.findall("p:resources/p:resource", places)
    test, *items = resources
    hrefs = [r.get("href") for r in resources]
    assert sorted(map(str, hrefs)) == sorted(files.keys() - {"imsmanifest.xml"})
    assert [f.get("href") for f in root.iter(f"{{{PACKAGE}}}file")] == hrefs
    assert test.get("type") == "imsqti_test_xmlv3p0"
    assert {r.get("type") for r in items} == {"imsqti_item_xmlv3p0"}
    needs = [d.get("identifierref") for d in test.findall("p:dependency", places)]
    assert needs == [r.get("identifier") for r in items]
    refs = [r.get("href") for r in ElementTree.fromstring(files["test.xml"]).iter(
        f"{{{ITEM}}}qti-assessment-item-ref")]  # fmt: skip
    assert refs == hrefs[1:]


@pytest.mark.parametrize("name", BANKS)
def test_names_in_an_item_are_there_once_and_lead_somewhere(name: str) -> None:
    for path, content in unpacked(BANKS[name]).items():
        if not path.startswith("items/"):
            continue
        root = ElementTree.fromstring(content)
        outcomes = [n.get("identifier") for n in root.iter(f"{{{ITEM}}}qti-outcome-declaration")]
        assert len(outcomes) == len(set(outcomes))
        for tag in ("qti-set-outcome-value", "qti-modal-feedback"):
            for node in root.iter(f"{{{ITEM}}}{tag}"):
                assert (node.get("outcome-identifier") or node.get("identifier")) in outcomes
        kinds = ("qti-simple-choice", "qti-simple-associable-choice")
        choices = [n.get("identifier") for n in root.iter() if local(n) in kinds]
        assert len(choices) == len(set(choices))
        right = [v.text or "" for v in root.iter(f"{{{ITEM}}}qti-value")
                 if choices and (v.text or "")[:1] in "CLR"]  # fmt: skip
        assert {part for value in right for part in value.split()} <= set(choices)


def tries(question: Question, q: Portable) -> list[tuple[Any, Any]]:
    """Answers: as a platform sends them, and as these pages keep them."""
    if q.order:
        letters = question.key()["order"]
        return [([f"L{k + 1}" for k in order], [letters[k] for k in order])
                for order in itertools.permutations(range(len(letters)))]  # fmt: skip
    if q.shape == "choice":
        return [(f"C{k}", option) for k, option in enumerate(question.asked()["options"], 1)]
    if q.shape == "choices":
        options = list(enumerate(question.asked()["options"], 1))
        some = [c for n in range(1, len(options) + 1) for c in itertools.combinations(options, n)]
        return [([f"C{k}" for k, _ in chosen], [o for _, o in chosen]) for chosen in some]
    if q.shape == "number":
        numbers = {q.number[0] + k * q.number[1] for k in (-2, -1.001, -1, -0.5, 0, 0.5, 1, 1.001)}
        numbers |= {w[0] + k * w[1] for w in q.wrong_numbers for k in (-1, 0, 1)}
        return [(n, n) for n in sorted(numbers)]
    if q.shape == "short":
        texts = ("zero", "ZERO", "nought", "much", *(a[0] for a in q.answers))
        return [(text, text) for text in texts]
    keyed = question.key()["pairs"]
    right = list(keyed.items())
    whole = [(f"L{k}", f"R{k}") for k in range(1, len(right) + 1)]
    sent = [f"{a} {b}" for a, b in whole]
    wrong = [f"L{k} R{len(whole) - k + 1}" for k in range(1, len(whole) + 1)]
    swapped = dict(zip([a for a, _ in right], [b for _, b in reversed(right)], strict=True))
    return [(sent, keyed), (wrong, swapped)]


@pytest.mark.parametrize("name", BANKS)
def test_a_platform_gives_the_marks_and_the_feedback_of_the_pages(name: str) -> None:
    bank = BANKS[name]
    files = unpacked(bank)
    taken, _ = portable(bank.items.values())
    tried = 0
    for q in taken:
        if q.shape == "essay":
            continue
        question = bank.items[q.id]
        platform = Platform(files[f"items/{q.id}.xml"], files["test.xml"])
        assert platform.answer(platform.correct)[0] == q.marks
        assert platform.answer(None) == (0, [])
        for sent, kept in tries(question, q):
            mark = question.mark(kept)
            score, shown = platform.answer(sent)
            assert score == mark.marks, (q.id, sent)
            own = [t for t in mark.shown if t != "explain" and t in question.feedback()]
            assert len(shown) == len(own) + bool(q.explain), (q.id, sent, shown)
            tried += 1
    assert tried > 4


def test_what_a_person_reads_says_so_and_has_its_rubric_for_the_scorer() -> None:
    root = ElementTree.fromstring(unpacked(BANKS["every-kind"])["items/why.xml"])
    (outcome,) = root.iter(f"{{{ITEM}}}qti-outcome-declaration")
    assert outcome.get("external-scored") == "human"
    assert outcome.get("normal-maximum") == "2"
    (rubric,) = root.iter(f"{{{ITEM}}}qti-rubric-block")
    assert rubric.get("view") == "scorer"
    assert "both & more" in "".join(rubric.itertext())
    assert root.find(f"{{{ITEM}}}qti-response-processing") is None


@pytest.mark.parametrize(
    ("html", "xml"),
    [("a <b>b <i>c</b> d", "a <b>b <i>c</i></b> d"), ("<script>alert(1)</script>x", "alert(1)x"),
     ("<p onclick='x'>a<br>b", "<p>a<br/>b</p>"), ("&nbsp;&copy;&#0;", "\u00a0©\ufffd"),
     ('<img src="a.svg">', '<img src="a.svg" alt=""/>'), ("</p></p>", "")],
)  # fmt: skip
def test_any_html_becomes_xml_of_known_elements(html: str, xml: str) -> None:
    assert flow(html) == xml
    ElementTree.fromstring(f"<x>{blocks(html)}</x>")


def test_a_package_says_its_language_and_has_a_name_of_its_own() -> None:
    taken, _ = portable(BANKS["own"].items.values())
    names = set()
    for name, language in (("newtons-third-law.ta", "ta"), ("விசை", "ta"), ("力", "zh-Hans")):
        made = qti_package("T", taken, name=name, language=language)
        with zipfile.ZipFile(io.BytesIO(made)) as archive:
            roots = {one: ElementTree.fromstring(archive.read(one))
                     for one in archive.namelist() if one.endswith(".xml")}  # fmt: skip
        names.add(roots["test.xml"].get("identifier"))
        assert f">{language}</imsmd:language>" in zipfile.ZipFile(io.BytesIO(made)).read(
            "imsmanifest.xml").decode()  # fmt: skip
        items = [root for one, root in roots.items() if one.startswith("items/")]
        assert items and {root.get(LANG) for root in items} == {language}
    assert len(names) == 3
    assert "carts-newtons-third-law-ta" in names


@pytest.mark.parametrize(
    ("path", "head", "language"),
    [
        ("worksheets/a.md", "", "en"),
        ("worksheets/ta/a.md", "", "ta"),
        ("worksheets/a.md", "---\nlanguage: ms\n---\n", "ms"),
        ("worksheets/banks/a.yml", "", None),
    ],
)
def test_a_package_speaks_the_language_of_its_page_and_a_bank_says_none(
    path: str, head: str, language: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = "id: a\ntype: single\nask: Q?\noptions: [{text: x, correct: true}, y]\n"
    of_bank = f"title: T\nitems:\n  - {asked.strip().replace(chr(10), chr(10) + '    ')}\n"
    file = tmp_path / path
    file.parent.mkdir(parents=True)
    lesson = f"{head}# T\n\n```question\n{asked}```\n"
    file.write_text(of_bank if path.endswith("yml") else lesson, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    result = CliRunner().invoke(main, ["export", path, "--to", "qti", "--out", "a.zip"])
    assert result.exit_code == 0, result.output
    with zipfile.ZipFile("a.zip") as archive:
        item = ElementTree.fromstring(archive.read("items/a.xml"))
    assert item.get(LANG) == language


@pytest.mark.parametrize(
    ("words", "shows"),
    [("newtons-third-law.md", True), ("newtons-third-law.md --form worksheet", True),
     ("test-forces-and-motion.md", False), ("test-forces-and-motion.md --form pre", False),
     ("banks/forces-and-motion.yml --form test-15", True)],
)  # fmt: skip
def test_feedback_is_shown_but_in_a_form_that_is_an_exam(
    words: str, shows: bool, tmp_path: Path
) -> None:
    path, *more = words.split()
    out = str(tmp_path / "a.zip")
    asked = ["export", str(ROOT / "worksheets" / path), *more, "--to", "qti", "--out", out]
    result = CliRunner().invoke(main, asked)
    assert result.exit_code == 0, result.output
    with zipfile.ZipFile(out) as archive:
        items = [name for name in archive.namelist() if name.startswith("items/")]
        test = archive.read("test.xml")
        assert Platform(archive.read(items[0]), test).shows is shows
    assert mistakes(ElementTree.fromstring(test)) == []


def test_equal_banks_give_equal_packages(tmp_path: Path) -> None:
    for name in ("a.zip", "b.zip"):
        words = ["export", str(OWN), "--to", "qti", "--out", str(tmp_path / name)]
        result = CliRunner().invoke(main, words)
        assert result.exit_code == 0, result.output
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()


def test_every_loss_is_told_for_the_format_that_has_it() -> None:
    taken, _ = portable(BANKS["more"].items.values())
    picture = "pic: its pictures are not in the file; add them on the platform"
    sure = "speed: how sure a student is, is not asked there"
    assert sorted(losses(taken, "qti")) == sorted(losses(taken, "moodle")) == [picture, sure]
    assert sorted(losses(taken, "gift")) == [
        picture,
        "speed: feedback on 2 known wrong numbers is not in this format",
        sure,
        "speed: it is worth 2 marks here and 1 there: GIFT knows no marks",
    ]


def test_moodle_gets_the_feedback_on_known_wrong_numbers_and_gift_does_not() -> None:
    taken, _ = portable(BANKS["more"].items.values())
    root = ElementTree.fromstring(moodle_xml("t", taken))
    (number,) = (q for q in root if q.get("type") == "numerical")
    answers = [(a.get("fraction"), a.findtext("text"), a.findtext("tolerance"),
                a.findtext("feedback/text")) for a in number.findall("answer")]  # fmt: skip
    assert answers == [
        ("100", "0.3", "0.01", None),
        ("0", "0.32", "0.01", "Near &amp; &lt;wrong&gt;"),
        ("0", "-0.3", "0.05", "The <em>other</em> way"),
    ]
    assert "other" not in gift("t", taken)
