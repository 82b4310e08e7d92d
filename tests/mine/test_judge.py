"""The judge: finds what is wrong with planted laws, and nothing in right ones."""

from __future__ import annotations

import pytest

from sim.bridge.protocol import answer
from sim.mine.follow import follow
from sim.mine.judge.as_yaml import as_yaml
from sim.mine.judge.checks import CHECKS
from sim.mine.judge.document import for_page, judged_so_far
from sim.mine.judge.scenes import usual
from sim.mine.judge.search import IN_A_PAGE, PARTS, judge, judge_part
from sim.pages.text.yaml.source import load
from sim.scene import read_scene
from tests.mine.laws import RIGHT, SPRING, WRONG

LONG = 3 * IN_A_PAGE
"""Questions. More than a page asks."""


@pytest.mark.parametrize("name", WRONG)
def test_a_counterexample_to_a_wrong_law_is_found_within_the_budget_of_a_page(name: str) -> None:
    text, broken = WRONG[name]
    found = judge(text)
    verdicts = {verdict.check: verdict for verdict in found.verdicts}
    assert not verdicts[broken].holds, found.verdicts
    assert found.calls < 1.5 * IN_A_PAGE


@pytest.mark.slow
@pytest.mark.parametrize("name", RIGHT)
def test_nothing_is_found_against_a_right_law_in_three_times_that_budget(name: str) -> None:
    found = judge(RIGHT[name], budget=LONG)
    assert found.holds, [v for v in found.verdicts if not v.holds]
    assert found.scenes > 12


@pytest.mark.parametrize("name", WRONG)
def test_the_worst_scene_is_an_ordinary_one_that_can_be_pasted_and_shows_it(name: str) -> None:
    text, broken = WRONG[name]
    verdict = next(one for one in judge(text).verdicts if one.check == broken)
    assert verdict.scene is not None
    pasted = read_scene(load(as_yaml(verdict.scene, verdict.sentence)).plain)
    assert pasted == read_scene({**verdict.scene, "title": verdict.sentence})
    if verdict.check == "third-law":
        done = follow(pasted)
        pair = done.samples.columns
        odd = [
            abs(a - b) for a, b in zip(pair["on", "A-B", "A"], pair["on", "A-B", "B"], strict=True)
        ]
        assert max(odd) > 0.5 * verdict.amount * max(map(abs, pair["F", "A-B"]))
    elif verdict.check == "energy":
        books = follow(pasted).run.ledger
        assert books.energy_final > books.energy_initial


BARELY_WRONG = {
    "energy": "def force(overlap, rate):\n"
    "    return 200*overlap if rate > 0 else 200.02*overlap\n",
    "third-law": "def force(overlap, side):\n"
    "    return 100*overlap*(1 + 1e-6*(side == 'left'))\n",
}  # fmt: skip


@pytest.mark.parametrize(("check", "text"), [
    *((broken, text) for text, broken in WRONG.values()), *BARELY_WRONG.items()
])  # fmt: skip
def test_what_breaks_a_law_is_told_as_two_numbers_that_differ(check: str, text: str) -> None:
    verdict = next(one for one in judge(text).verdicts if one.check == check)
    assert not verdict.holds
    values = [value for name, value in verdict.sentence.values.items() if name not in ALONE]
    assert len(set(values)) == len(values), verdict.sentence


ALONE = {"cart", "time"}
"""Values of sentences that stand for themselves."""


@pytest.mark.parametrize("name", ["spring", "hertz"])
def test_one_judgement_comes_from_one_law_seed_and_budget(name: str) -> None:
    assert judge(RIGHT[name]) == judge(RIGHT[name])
    assert judge(RIGHT[name]).calls != judge(RIGHT[name], seed=21).calls


@pytest.mark.parametrize("name", ["the heavier one feels more", "rubs on the track"])
def test_parts_that_a_page_asks_for_come_to_the_same_judgement(name: str) -> None:
    text = WRONG[name][0]
    judged = None
    for part in range(PARTS):
        judged = judge_part(text, "mine.py", part, judged)
        judged = judged_so_far(for_page(judged), {"mine.py": text})
    whole = judge(text)
    assert judged is not None
    assert [(v.check, v.holds, v.amount, v.scene) for v in judged.verdicts] == [
        (v.check, v.holds, v.amount, v.scene) for v in whole.verdicts
    ]


def test_a_law_of_equal_answers_breaks_no_symmetry_and_a_spring_no_energy() -> None:
    """Every check says a number, and those of a spring are rounding or the error of its steps."""
    found = judge(SPRING)
    assert [one.check for one in found.verdicts] == list(CHECKS)
    assert all(one.amount <= 0.1 * one.limit for one in found.verdicts)


def test_what_a_law_does_not_ask_for_is_no_excuse_for_one_that_remembers() -> None:
    text = WRONG["who asks first gets more"][0]
    verdicts = {one.check: one for one in judge(text).verdicts}
    assert not verdicts["mirror"].holds and not verdicts["order"].holds


def test_the_judge_begins_with_the_numbers_of_a_scene_also_where_nothing_is_given_back() -> None:
    scene = read_scene(
        {
            "carts": {
                "A": {"mass": 1.0, "position": 0.4, "velocity": 0.5},
                "B": {"mass": 1.0, "position": 1.0},
            },
            "contact": {"law": "mine.py", "stiffness": 200, "restitution": 0},
            "laws": {"mine.py": SPRING},
        }
    )
    assert usual(scene).restitution == 0.0


def test_of_two_laws_in_a_scene_the_one_that_was_asked_about_is_judged() -> None:
    scene = {
        "carts": {
            "A": {"mass": 1.0, "position": 0.4, "velocity": 0.5},
            "B": {"mass": 1.0, "position": 1.0},
            "C": {"mass": 1.0, "position": 1.6},
        },
        "contact": {"law": "mine.py", "pairs": {"A-B": {"law": "first.py"}}},
        "laws": {"first.py": SPRING, "mine.py": WRONG["the heavier one feels more"][0]},
    }
    request = {"kind": "law", "do": "judge", "scene": scene, "part": 0}
    for law, holds in (("first.py", True), ("mine.py", False)):
        header, _ = answer({**request, "law": law})
        assert header["judged"]["law"] == law
        verdicts = {one["check"]: one["holds"] for one in header["judged"]["verdicts"]}
        assert verdicts["third-law"] == holds
    assert not answer({**request, "law": "other.py"})[0]["ok"]
