"""Banks, forms drawn from them, when they open, and the code for paper."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from sim.lesson import LessonError
from sim.lesson.bank import Bank
from sim.lesson.beliefs import BELIEFS
from sim.lesson.form import read_form
from sim.lesson.key_file import key_file
from sim.lesson.keys import whole
from sim.lesson.opening import word_sum
from sim.pages.question.quiz import read_bank_text
from sim.pages.question.render import render_quiz
from sim.scene.problem import Problem
from tests.web.question.question_site import BANK
from tests.web.scene.given.widget_site import in_node

ROOT = Path(__file__).parents[2]
FORM = {"id": "f", "form": "pre", "mode": "exam", "bank": "x.yml"}


def bank(path: Path) -> Bank:
    read, mistakes = read_bank_text(path.read_text(encoding="utf-8"), path.name)
    assert mistakes == []
    assert read is not None
    return read


OURS = bank(ROOT / "worksheets" / "banks" / "forces-and-motion.yml")
SMALL = bank(BANK / "small.yml")


def problems(changes: dict[str, object]) -> list[str]:
    with pytest.raises(LessonError) as error:
        read_form({**FORM, **changes}, OURS)
    return [problem.code for problem in error.value.problems]


def test_a_form_draws_by_topic_and_level_in_the_order_of_the_bank() -> None:
    drawn = read_form({**FORM, "draw": [{"topics": ["second-law"], "count": 4}]}, OURS)
    assert [item.id for item in drawn.items] == ["fan-cart", "trolley", "barge", "spring-carts"]
    both = [
        {"topics": "third-law", "count": 1},
        {"topics": "first-law", "level": "core", "count": 2},
    ]
    assert [i.id for i in read_form({**FORM, "draw": both}, OURS).items] == ["lamp", "bed", "boats"]
    assert problems({"draw": [{"topics": ["third-law"], "count": 9}]}) == ["too-few-items"]


def test_mistakes_in_a_form_are_named() -> None:
    assert problems({}) == ["not-a-choice"]
    assert problems({"use": "test-15", "items": ["lamp"]}) == ["not-a-choice"]
    assert problems({"items": ["lamb"]}) == ["unknown-item"]
    assert problems({"items": ["lamp", "lamp"]}) == ["twice"]
    assert problems({"use": "test-15", "open": {"word": "abc"}}) == ["bad-name"]
    assert problems({"use": "test-15", "open": {"date": "1.3.2027"}}) == ["not-a-date"]
    assert problems({"use": "test-15", "open": {"days": 3}}) == ["missing"]
    assert problems({"use": "test-15", "open": {"done": "worksheet", "days": 3}}) == ["missing"]
    assert problems({"use": "test-15", "close": {"word": "FALCON"}}) == ["unknown-key"]


@pytest.mark.parametrize(
    ("last", "found"), [("2027-03-01", []), ("2027-03-02", []), ("2027-02-28", ["out-of-range"])]
)
def test_a_form_may_be_open_for_one_day_and_not_for_less(last: str, found: list[str]) -> None:
    dates = {"open": {"date": "2027-03-01"}, "close": {"date": last}}
    if found:
        assert problems({"use": "test-15", **dates}) == found
    else:
        read_form({**FORM, "use": "test-15", **dates}, OURS)


def test_before_and_after_are_the_same_form_and_know_each_other_by_ids() -> None:
    pre, post = (
        read_form({**FORM, "form": form, "use": "test-15"}, OURS) for form in ("pre", "post")
    )
    assert [i.id for i in pre.items] == [i.id for i in post.items]
    assert pre.hash == post.hash


def test_an_exam_page_holds_nothing_of_its_key() -> None:
    form = read_form({**FORM, "bank": "small.yml", "use": "both", "mode": "exam"}, SMALL)
    page = render_quiz(form)
    secrets = re.findall(r"(?:FEEDBACK|HINT|EXPLANATION|NOTE|RUBRIC)[A-Z-]+", page)
    assert secrets == []
    for word in ("correct", "belief", 'answer":', "template", *BELIEFS):
        assert word not in page.replace("answer’s", ""), word
    practice = render_quiz(read_form({**FORM, "items": ["net-force"], "mode": "practice"}, SMALL))
    assert "FEEDBACK-TO-ZERO" in practice


def test_in_an_exam_right_and_wrong_answers_look_alike() -> None:
    """Swapping which answer is right changes no byte of the page."""
    text = (BANK / "small.yml").read_text(encoding="utf-8")
    swapped = text.replace(
        "{text: forwards, belief: motion-needs-force, feedback: FEEDBACK-TO-FORWARDS}",
        "{text: forwards, correct: true}",
    ).replace("{text: zero, correct: true, feedback: FEEDBACK-TO-ZERO}", "{text: zero}")
    assert text != swapped
    pages = []
    for source in (text, swapped):
        read = read_bank_text(source, "small.yml")[0]
        assert read is not None
        pages.append(render_quiz(read_form({**FORM, "use": "both"}, read)))
    assert pages[0] == pages[1]


def test_the_key_file_holds_what_the_page_does_not() -> None:
    form = read_form({**FORM, "use": "both"}, SMALL)
    key = key_file("site", "lesson", [], [form])
    (part,) = key["forms"]
    assert part["hash"] == form.hash
    assert part["options"] == [["net-force", 3], ["light-boat", 4]]
    first = part["items"][0]
    assert first["key"]["correct"] == ["b"]
    assert first["beliefs"].keys() == {"motion-needs-force", "negative-means-slowing"}
    json.dumps(key, allow_nan=False)


# ---------------------------------------------------------------- our own test


def test_our_test_has_eighteen_items_seven_seven_and_four() -> None:
    items = [OURS.items[i] for i in OURS.forms["test-18"]]
    topics = [item.common.topics[0] for item in items]
    assert [topics.count(t) for t in ("first-law", "third-law", "second-law")] == [7, 7, 4]
    later = [OURS.items[i] for i in OURS.forms["later-2"]]
    assert [item.data(key=False)["marks"] for item in later] == [2, 2]


def test_our_items_keep_the_rules_of_good_items() -> None:
    letters = []
    for name in OURS.forms["test-18"]:
        item = OURS.items[name]
        key = item.key()
        letters += key["correct"]
        texts = list(item.texts().values())
        assert 4 <= len(texts) <= 5, name
        wrong = len(texts) - 1
        assert len(key["beliefs"]) == wrong, f"{name}: every wrong answer has its belief"
        words = re.findall(r"[\w'.−-]+", re.sub(r"\|[^\n]*\|", "", item.common.ask))
        assert len(words) <= 60, (name, len(words))
        assert not re.search(r"\b(all|none) of the above\b", " ".join(texts).lower())
        assert item.common.note, name
        right = len(texts["abcde".index(key["correct"][0])])
        longest = max(map(len, texts))
        assert right <= 1.5 * sorted(map(len, texts))[-2] or right < longest, name
    assert {letter: letters.count(letter) for letter in "abcd"} == {"a": 5, "b": 5, "c": 4, "d": 4}


ONCE = {
    "negative-means-slowing",  # a matter of signs: one item with a table of velocities
    "own-mass-own-force",  # one item gives the forces in numbers, as the lesson's hidden forces
}
LAWS = ("newtons-first-law", "newtons-second-law", "newtons-third-law")


def test_every_belief_of_the_lessons_can_be_seen_twice() -> None:
    """One item is no diagnosis: a belief that a lesson speaks of stands in two of each form."""
    counts = dict.fromkeys(BELIEFS, 0)
    for name in OURS.forms["test-18"]:
        for belief in set(OURS.items[name].key()["beliefs"].values()):
            counts[belief] += 1
    lessons = [(ROOT / "worksheets" / f"{law}.md").read_text(encoding="utf-8") for law in LAWS]
    named = {belief for text in lessons for belief in re.findall(r"belief: ([a-z-]+)", text)}
    assert len(named) > 15
    assert {belief for belief in named if counts[belief] < 2} == ONCE


# ---------------------------------------------------------------- opening rules


def test_the_page_opens_forms_by_their_rules() -> None:
    state = {"words": [], "answered": False, "handed": {}}
    word = word_sum("forces-post", "Falcon")
    rules = [
        ({}, state, 0),
        ({"word": word}, state, 1),
        ({"word": word}, {**state, "words": [word]}, 0),
        ({"date": "2026-11-22"}, state, 1),
        ({"date": "2026-11-21"}, state, 0),
        ({"done": "worksheet"}, state, 1),
        ({"done": "worksheet"}, {**state, "answered": True}, 0),
        ({"done": "post"}, state, 1),
        ({"done": "post"}, {**state, "handed": {"post": "2026-11-21T08:00:00Z"}}, 0),
        ({"done": "post", "days": 14}, {**state, "handed": {"post": "2026-11-10T08:00:00Z"}}, 1),
        ({"done": "post", "days": 14}, {**state, "handed": {"post": "2026-11-01T08:00:00Z"}}, 0),
        ({"done": "post", "days": 14}, {**state, "handed": {"post": "2026-11-07T12:00:00Z"}}, 0),
        ({"done": "post", "days": 14}, {**state, "handed": {"post": "2026-11-08T12:00:00Z"}}, 1),
        ({"done": "post", "word": word}, state, 2),
    ]
    script = """const { reasons, isOver, wordSum } = await import(source + "/question/opening.js");
    const now = new Date(2026, 10, 21, 12);
    give({ why: data.map(([rule, state]) => reasons(rule, { ...state, now }).length),
      over: ["2026-11-20", "2026-11-21"].map((date) => isOver({ date }, now)),
      word: wordSum("forces-post", " fal con ") });"""
    made = in_node(script, rules)
    assert made["why"] == [count for _, _, count in rules]
    assert made["over"] == [True, False]
    assert made["word"] == word


# ---------------------------------------------------------------- the code for paper


@pytest.mark.parametrize("value", [0, 601, 2.5, True])
def test_a_number_that_is_too_large_is_told_how_far_it_may_go(value: object) -> None:
    problems: list[Problem] = []
    assert whole({"minutes": value}, "minutes", (), problems, default=3) == 3
    assert [one.message for one in problems] == ["minutes is a whole number from 1 to 600"]
