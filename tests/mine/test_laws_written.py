"""Laws in Python: that they move carts well, and what a scene with one says."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.mine.arguments import ARGUMENTS
from sim.mine.field import OWN
from sim.mine.follow import follow
from sim.mine.instance import read_law
from sim.mine.judge.chance import Chance
from sim.mine.judge.scenes import USUAL, WIDE, at_random, plain
from sim.mine.judge.trial import Counter, Trial
from sim.scene import SceneError, read_scene
from tests.mine.laws import PAIR, RIGHT, SPRING, WRONG, with_law

STEPS = 2e-8
"""m/s, m. What steps of relative error 1e-9 may be off by at the end of a run."""

WIDER_STEPS = 1e-4
"""m/s, m. The same for the steps of the judge, over a kink."""

ROW: dict[str, Any] = {
    "carts": {
        "A": {"mass": 0.5, "position": 0.5, "velocity": 0.6},
        "B": {"mass": 1.0, "position": 1.0},
        "C": {"mass": 0.7, "position": 1.25, "velocity": -0.2},
    },
    "track": {"left": "wall", "right": "wall", "length": 2.0},
    "effects": [{"friction": {"coefficient": 0.004}}],
    "until": 4.0,
}
TWINS = {
    "push-only, e = 1": (SPRING, {"law": "push-only", "stiffness": 150, "restitution": 1}),
    "hertz": (
        "def force(overlap, rate, stiffness):\n    return stiffness * overlap ** 1.5\n",
        {"law": "hertz", "stiffness": 4000, "restitution": 1},
    ),
}


@pytest.mark.parametrize("name", ["push-only, e = 1", "hertz"])
@pytest.mark.parametrize("scene", [PAIR, ROW], ids=["pair", "row between walls, with friction"])
def test_a_law_written_down_moves_carts_as_the_same_law_of_ours(
    name: str, scene: dict[str, Any]
) -> None:
    text, contact = TWINS[name]
    numbers = {key: contact[key] for key in ("stiffness", "restitution")}
    ours = run(read_scene({**scene, "contact": contact}))
    mine = follow(read_scene(with_law(scene, text, **numbers)))
    assert mine.run.v == pytest.approx(ours.v, abs=STEPS)
    assert mine.run.x == pytest.approx(ours.x, abs=STEPS)
    assert not mine.unequal
    assert mine.run.ledger.warmed == pytest.approx(ours.ledger.warmed, abs=STEPS)
    kinds = [
        (e.kind, e.bodies) for e in mine.run.record.events if e.kind in ("contact", "separate")
    ]
    assert kinds == [
        (e.kind, e.bodies) for e in ours.record.events if e.kind in ("contact", "separate")
    ]


def test_a_law_written_down_is_asked_as_ever_when_carts_stick_together() -> None:
    scene = {**ROW, "until": 2.5}
    text, contact = TWINS["push-only, e = 1"]
    numbers = {key: contact[key] for key in ("stiffness", "restitution")}
    joined = {"pairs": {"B-C": {"law": "velcro"}}}
    ours = run(read_scene({**scene, "contact": contact | joined}))
    written = with_law(scene, text, **numbers)
    mine = follow(read_scene({**written, "contact": written["contact"] | joined}))
    assert mine.run.v == pytest.approx(ours.v, abs=STEPS)
    assert mine.run.record.counts == ours.record.counts


@pytest.mark.parametrize("name", WRONG)
def test_accounts_close_with_what_came_from_nowhere_under_its_own_name(name: str) -> None:
    done = follow(read_scene(with_law(PAIR, WRONG[name][0])))
    books = done.run.ledger
    assert books.momentum_final == pytest.approx(books.momentum_initial + books.external, abs=1e-7)
    given = math.fsum(books.works.values())
    in_play = books.energy_initial + abs(given) + abs(books.warmed)
    assert books.energy_final + books.warmed == pytest.approx(
        books.energy_initial + given, abs=1e-6 * in_play
    )
    assert (OWN in books.impulses) == done.unequal
    assert any(key[0] == "on" for key in done.samples.columns) == done.unequal


def test_a_force_that_goes_with_ones_own_mass_leaves_with_one_change_of_velocity() -> None:
    """a_A = −c d and a_B = +c d: both velocities change by the closing speed."""
    text = WRONG["the heavier one feels more"][0]
    done = follow(read_scene(with_law(PAIR, text)))
    assert done.run.v == pytest.approx((0.0, 0.4), abs=STEPS)
    assert done.run.ledger.impulses[OWN] == pytest.approx(0.5 * 0.4 - 2.0 * 0.4, abs=STEPS)


@pytest.mark.parametrize("name", [*RIGHT, *WRONG])
def test_the_judges_own_steps_and_those_of_a_scene_find_one_motion(name: str) -> None:
    text = RIGHT.get(name) or WRONG[name][0]
    if "asked" in text or "last" in text or "turns" in text:
        pytest.skip("remembers what it was asked: no two ways of steps agree on it")
    chance = Chance(5)
    for _ in range(3):
        scene = plain(at_random(chance, WIDE, read_law(text).wants, USUAL), text, "mine.py")
        quick = Trial(scene, Counter(100_000)).end("plain")
        slow = follow(read_scene(scene)).run
        assert quick is not None
        assert quick.v == pytest.approx(slow.v, abs=WIDER_STEPS)
        assert quick.x == pytest.approx(slow.x, abs=WIDER_STEPS)


def test_every_argument_has_the_value_that_its_words_say() -> None:
    names = ", ".join(ARGUMENTS)
    text = f"""\
seen = []

def force({names}):
    if not seen:
        seen.append(({names}))
        assert_ = 1 / (time > 0)
    if side == "left":
        good = mass_self == 2 and mass_other == 0.5 and name_self == "A" and name_other == "B"
        good = good and velocity_self - velocity_other - rate < 1e-12
    else:
        good = mass_self == 0.5 and mass_other == 2 and name_self == "B" and name_other == "A"
        good = good and velocity_other - velocity_self - rate < 1e-12
    good = good and abs(reduced_mass - 0.4) < 1e-15 and stiffness == 70 and restitution == 0.25
    return stiffness * overlap if good else 0 / 0
"""
    done = follow(read_scene(with_law(PAIR, text, stiffness=70, restitution=0.25)))
    assert done.run.v == pytest.approx((0.24, 0.64), abs=STEPS)


def test_a_wall_is_infinite_and_is_not_asked() -> None:
    scene = {
        "carts": {"A": {"mass": 0.5, "position": 0.5, "velocity": 0.6}},
        "track": {"right": "wall", "length": 1.5},
        "until": 3.0,
    }
    text = """\
def force(overlap, rate, mass_self, mass_other, reduced_mass, name_self):
    if name_self != "A" or mass_other < 1e308 or reduced_mass != 0.5:
        return 0
    return 100 * overlap
"""
    done = follow(read_scene(with_law(scene, text)))
    assert done.run.v == pytest.approx((-0.6,), abs=STEPS)
    assert not done.unequal


def test_every_run_begins_with_a_law_that_remembers_nothing() -> None:
    text = WRONG["gets tired"][0]
    scene = read_scene(with_law(PAIR, text))
    assert follow(scene).run.v == follow(scene).run.v


def test_a_missing_text_and_a_wrong_name_are_problems_of_the_scene() -> None:
    with pytest.raises(SceneError) as found:
        read_scene({**PAIR, "contact": {"law": "mine.py"}})
    assert found.value.problems[0].path == ("contact", "law")
    with pytest.raises(SceneError) as found:
        read_scene({**PAIR, "laws": {"../mine.py": SPRING}})
    assert found.value.problems[0].path == ("laws", "../mine.py")


@pytest.mark.parametrize("method", ["euler", "rk4", "rk4-events"])
def test_no_other_solver_takes_such_a_scene(method: str) -> None:
    scene = read_scene(with_law(PAIR, SPRING))
    with pytest.raises(UnsolvedError):
        run(scene)
    with pytest.raises(UnsolvedError):
        stepped(scene, MethodChoice(method, 1e-3))


@pytest.mark.parametrize("text", ["", " \n\t"])
def test_an_empty_law_is_told_how_it_begins(text: str) -> None:
    """In a page this is an emptied box: before, “the law mine.py is a text” stood below it."""
    with pytest.raises(SceneError) as found:
        read_scene({**PAIR, "contact": {"law": "mine.py"}, "laws": {"mine.py": text}})
    (problem,) = found.value.problems
    assert problem.message == "there is no function called force here"
    assert problem.hint == "begin with def force(overlap, rate):"
