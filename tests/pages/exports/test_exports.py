"""Banks for learning platforms: golden files, and readers of our own that find every fact again.

The readers below follow Moodle's own documents (Moodle XML format, GIFT format), not our writer.
"""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from sim.cli import main
from sim.pages.classroom.gift import gift
from sim.pages.classroom.losses import losses
from sim.pages.classroom.moodle import moodle_xml
from sim.pages.classroom.moodle_text import plain_text
from sim.pages.classroom.portable import Portable, portable
from sim.pages.question.key_page import lesson_key
from sim.pages.question.quiz import read_bank_text
from sim.pages.text.lesson_places import described
from tests.pages.given.banks import OWN, read
from tests.pages.given.exported import facts, from_gift, from_moodle

ROOT = Path(__file__).parents[3]
GOLDEN = ROOT / "tests" / "golden" / "exports"


BANKS = {"every-kind": read(GOLDEN / "every-kind.yml"), "own": read(OWN)}
TAKEN = {name: portable(bank.items.values())[0] for name, bank in BANKS.items()}
WRITERS = {"moodle.xml": moodle_xml, "gift.txt": gift}


@pytest.mark.parametrize("ending", WRITERS)
def test_the_export_of_every_kind_is_the_golden_file(ending: str) -> None:
    made = WRITERS[ending](BANKS["every-kind"].title, TAKEN["every-kind"])
    assert made == (GOLDEN / f"every-kind.{ending}").read_text(encoding="utf-8")


def test_what_cannot_be_taken_along_is_named() -> None:
    assert portable(BANKS["every-kind"].items.values())[1] == [
        "sure: a question of type confidence stays here"
    ]


LONG = "type: long\nrubric: {1: Both., 0: Else.}\nstart: It is"
LESSONS = sorted(
    path
    for path in (ROOT / "worksheets").glob("*.md")
    if re.search(r"^```(question|quiz)$", path.read_text(encoding="utf-8"), re.MULTILINE)
)


@pytest.mark.parametrize("path", LESSONS, ids=lambda path: path.stem)
def test_every_question_of_a_lesson_is_in_the_file_or_named_as_left_behind(
    path: Path, tmp_path: Path
) -> None:
    keys = {
        item["id"]
        for form in made_key(path)["forms"]
        for item in form["items"]
    }  # fmt: skip
    out = tmp_path / "x.xml"
    result = CliRunner().invoke(main, ["export", str(path), "--out", str(out)])
    nothing = result.exit_code == 1 and "no question that a platform could take" in result.stderr
    assert nothing or result.exit_code == 0, result.output
    taken = (
        {str(fact["id"]) for fact in from_moodle(out.read_text("utf-8"))} if out.exists() else set()
    )
    left = set(re.findall(r"^(\S+): a question of type \w+ stays here$", result.stderr, re.M))
    assert taken | left == keys
    assert not taken & left


def made_key(path: Path) -> dict[str, Any]:
    """The key of a lesson: what it asks, read by another way."""
    key = lesson_key(path.read_text(encoding="utf-8"), described(path, ROOT), path.stem, "x")
    assert key is not None
    return key.content


def test_the_export_of_a_lesson_says_what_its_scenes_did_for_it(tmp_path: Path) -> None:
    third = str(ROOT / "worksheets" / "newtons-third-law.md")
    words = ["export", third, "--form", "worksheet", "--out", str(tmp_path / "x.xml")]
    told = CliRunner().invoke(main, words).stderr.splitlines()
    assert (
        "third-cancel: it is about the scene “third-light-into-heavy”, which stays here: link to "
        "the lesson" in told
    )
    assert "third-wall: what is predicted before its run stays here" in told
    assert "third-answer: the student's first idea is not shown beside it there" in told


def test_a_translated_lesson_is_exported_in_its_language(tmp_path: Path) -> None:
    out = tmp_path / "x.xml"
    words = ["export", str(ROOT / "worksheets" / "newtons-second-law.md"), "--out", str(out)]
    assert CliRunner().invoke(main, [*words, "--language", "ms"]).exit_code == 0
    malay = out.read_text(encoding="utf-8")
    assert "Hukum kedua Newton" in malay
    assert "Answer in" not in malay and "<p>Jawab dalam N.</p>" in malay


def one_question(tmp_path: Path, question: str, *words: str) -> tuple[str, str]:
    """What is exported of a lesson with one question, and what is said about it."""
    lesson, out = tmp_path / "one.md", tmp_path / "one.out"
    lesson.write_text(f"# One\n\n```question\nid: one\n{question}\n```\n", encoding="utf-8")
    result = CliRunner().invoke(main, ["export", str(lesson), "--out", str(out), *words])
    return out.read_text(encoding="utf-8") if out.exists() else "", result.output


@pytest.mark.parametrize("target", ["moodle", "gift"])
def test_a_star_in_a_short_answer_is_a_star_and_not_anything(tmp_path: Path, target: str) -> None:
    made, _ = one_question(tmp_path, "type: short\nask: Which?\naccept: ['m*a']", "--to", target)
    assert r"m\*a" in made
    assert r"m\\*a" not in made


def test_accepted_words_beside_a_rubric_keep_its_marks_and_name_where_it_stays(
    tmp_path: Path,
) -> None:
    short = "type: short\nask: Which?\naccept: [both]\nrubric: {2: Both., 1: One., 0: Else.}"
    made, said = one_question(tmp_path, short)
    assert "<defaultgrade>2</defaultgrade>" in made
    assert "one: its rubric is not there" in said
    _, said = one_question(tmp_path, short, "--to", "gift")
    assert "it is worth 2 marks here and 1 there" in said
    bank = f"title: One\nitems:\n  - id: one\n    {short.replace(chr(10), chr(10) + '    ')}\n"
    found, _ = read_bank_text(bank, "one.yml")
    assert found is not None
    taken, _ = portable(found.items.values())
    assert (taken[0].marks, list(losses(taken, "qti"))) == (2, [])


def test_more_right_answers_than_moodle_knows_shares_of_are_named(tmp_path: Path) -> None:
    options = "".join(f"\n  - {{text: right {k}, correct: true}}" for k in range(11))
    question = f"type: multiple\nask: Which?\noptions:{options}\n  - {{text: wrong}}"
    made, said = one_question(tmp_path, question)
    assert not made
    assert "11 right answers; Moodle refuses more than 10" in said


def test_a_question_that_leads_elsewhere_says_so(tmp_path: Path) -> None:
    _, said = one_question(tmp_path, f"{LONG}\nask: 'See [the rule](index.md).'")
    assert "one: its links lead to pages of this site" in said
    assert "<text><![CDATA[It is]]></text>" in one_question(tmp_path, f"{LONG}\nask: Why?")[0]


def test_an_arrow_in_an_accepted_answer_is_not_written_as_a_pair(tmp_path: Path) -> None:
    question = "type: short\nask: Which?\naccept: ['A -> B']"
    made, said = one_question(tmp_path, question, "--to", "gift")
    assert not made
    assert "takes the arrow" in said
    assert "A -> B" in one_question(tmp_path, question)[0]


@pytest.mark.parametrize("target", ["moodle", "gift"])
def test_words_to_use_and_the_beginning_of_a_few_words_are_named_as_lost(
    tmp_path: Path, target: str
) -> None:
    question = (
        "type: short\nask: Which?\naccept: [equal]\nwords: [equal, opposite]\nstart: They are"
    )
    _, said = one_question(tmp_path, question, "--to", target)
    assert "one: the words to use are not shown there" in said
    assert "one: the beginning of the answer is not given there" in said


def test_of_a_picture_in_a_list_its_words_stay() -> None:
    assert plain_text('<img alt="two carts" src="a.png"> meet') == "two carts meet"


def test_texts_stand_as_they_are_for_moodle_drops_blanks_between_escaped_signs() -> None:
    """Its reader (lib/xmlize.php) leaves pieces of text out that are blank, and gets a new piece at
    every escaped sign: `a &lt; &amp; b` comes in as `a <& b`."""
    pairs = (("*A* & *B*", "<em>on</em> <em>C</em> &amp; D"), ("E", "F"), ("G", "H"))
    paired = Portable(id="p", shape="pairs", ask="<b>x</b> <i>y</i>", marks=1, pairs=pairs)
    made = moodle_xml("A & < B", [
        paired,
        Portable(id="s", shape="short", ask="?", marks=1, answers=(("a < & > b", 100.0, ""),)),
        Portable(id="e", shape="essay", ask="?", marks=1, start="The < & >", rubric={1: "& &"}),
    ])  # fmt: skip
    plain = re.sub(r"<!\[CDATA\[.*?\]\]>", "", made, flags=re.DOTALL)
    assert "&" not in plain
    assert "<text><![CDATA[on C & D]]></text>" in made  # a list to choose from shows no marks
    assert "-> on C & D\n" in gift("A", [paired])
    assert "<text><![CDATA[a < & > b]]></text>" in made


@pytest.mark.parametrize(("order", "shuffled"), [((), "true"), (("a", "b"), "false")])
def test_places_of_an_ordering_keep_their_order_in_moodle(
    order: tuple[str, ...], shuffled: str
) -> None:
    pairs = (("1.", "a"), ("2.", "b"))
    made = moodle_xml("A", [Portable(id="p", shape="pairs", ask="?", marks=1, pairs=pairs,
                                     order=order)])  # fmt: skip
    assert f"<shuffleanswers>{shuffled}</shuffleanswers>" in made


@pytest.mark.parametrize("name", BANKS)
def test_moodle_xml_holds_every_question_answer_and_feedback(name: str) -> None:
    made = moodle_xml(BANKS[name].title, TAKEN[name])
    assert from_moodle(made) == [facts(q) for q in TAKEN[name]]


@pytest.mark.parametrize("name", BANKS)
def test_gift_holds_every_question_answer_and_feedback(name: str) -> None:
    made = gift(BANKS[name].title, TAKEN[name])

    def arrows(fact: dict[str, object]) -> str:
        return unescape(str(fact))  # “->” inside a text is written as &gt;

    assert [arrows(f) for f in from_gift(made)] == [arrows(facts(q)) for q in TAKEN[name]]


def test_the_marks_of_the_right_answers_add_up_to_the_whole() -> None:
    for questions in TAKEN.values():
        for q in questions:
            if q.shape in ("choice", "choices"):
                assert sum(p for _, p, _ in q.answers if p > 0) == pytest.approx(100)


def test_the_command_writes_a_form_of_a_bank(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "x.gift"
    words = ["export", str(OWN), "--to", "gift", "--form", "later-2", "--out", str(target)]
    result = CliRunner().invoke(main, words)
    assert result.exit_code == 0, result.output
    assert target.read_text(encoding="utf-8").count("::[html]") == 2
    monkeypatch.chdir(tmp_path)  # no form takes the place of another's file
    assert CliRunner().invoke(main, words[:-2]).exit_code == 0
    made = [one.name for one in Path("build/export").iterdir()]
    assert made == ["forces-and-motion.later-2.gift.txt"]
    assert CliRunner().invoke(main, ["export", str(OWN), "--form", "nothing"]).exit_code == 2
