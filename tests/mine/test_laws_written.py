"""Laws in Python: what they may be, what is said of wrong ones, and that they move carts well."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.stepping.methods import Way
from sim.dynamics.stepping.recorded import stepped
from sim.mine.arguments import ARGUMENTS
from sim.mine.field import OWN
from sim.mine.follow import follow
from sim.mine.instance import Instance, read_law
from sim.mine.judge.chance import Chance
from sim.mine.judge.scenes import USUAL, WIDE, at_random, plain
from sim.mine.judge.trial import Counter, Trial
from sim.mine.wrong import WrongLawError
from sim.scene import SceneError, read_scene
from tests.mine.laws import RIGHT, SPRING, WRONG

STEPS = 2e-8
"""m/s, m. What steps of relative error 1e-9 may be off by at the end of a run."""

WIDER_STEPS = 1e-4
"""m/s, m. The same for the steps of the judge, over a kink."""

PAIR: dict[str, Any] = {
    "carts": {
        "A": {"mass": 2.0, "position": 0.4, "velocity": 0.4},
        "B": {"mass": 0.5, "position": 1.2},
    },
    "until": 3.0,
}
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


def with_law(scene: dict[str, Any], text: str, **contact: Any) -> dict[str, Any]:
    return {**scene, "contact": {"law": "mine.py", **contact}, "laws": {"mine.py": text}}


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


WRONG_TEXTS = {
    "no Python": ("def force(overlap)\n    return 1\n", 1, "not Python"),
    "no function": ("x = 1\n", 1, "no function called force"),
    "another module": ("import math\nimport os\ndef force(overlap):\n    return 1\n", 2, "“os”"),
    "a part of another": ("from sys import path\ndef force(overlap):\n    return 1\n", 1, "“sys”"),
    "an unknown argument": ("\ndef force(overlap, speed):\n    return 1\n", 2, "“speed”"),
    "a star": ("def force(*all):\n    return 1\n", 1, "without *"),
    "not a number": ("def force(overlap):\n    x = 1\n    return 'much'\n", 3, "this is str"),
    "nothing": ("def force(overlap):\n    overlap + 1\n", 1, "without a return"),
    "nan": ("def force(overlap):\n    x = 1e300 * 1e300\n    return x - x\n", 3, "nan"),
    "infinity": ("def force(overlap):\n    return 1e308 * 10 + overlap\n", 2, "inf"),
    "a complex number": ("def force(overlap):\n    return (overlap - 1) ** 0.5\n", 2, "complex"),
    "a division by nought": ("def force(overlap):\n    a = 0\n    return 1 / a\n", 3, "Zero"),
    "an unknown name": ("def force(overlap):\n    return k * overlap\n", 2, "“k”|'k'"),
    "an endless loop": ("def force(overlap):\n    x = 1\n    while x:\n        x = 2\n",
                        3, "goes on and on"),
    "an endless loop outside": ("while True:\n    pass\ndef force(overlap):\n    return 1\n", 1,
                                "goes on and on"),
    "a long count": ("def force(overlap):\n    return sum(i for i in range(10**9))\n", 2, "range"),
    "a function that calls itself": (
        "def f(x):\n    return f(x)\ndef force(overlap):\n    return f(1)\n", 1, "Recursion"
    ),
    "a huge power": ("def force(overlap):\n    return 10 ** 10 ** 10\n", 2, "power"),
    "a huge power in place": (
        "def force(overlap):\n    x = 9\n    x **= 9 ** 5\n    return 1\n", 3, "power"
    ),
    "a power in a list": (
        "def force(overlap):\n    x = [9]\n    x[0] **= 9 ** 5\n    return 1\n", 3, "power"
    ),
    "a long shift": ("def force(overlap):\n    return 1 << 10 ** 6\n", 2, "whole number"),
    "a number squared again and again": (
        "def force(overlap):\n    x = 9\n    for k in range(16):\n        x = x * x\n    return 1",
        4, "whole number"
    ),
    "a long list": ("def force(overlap):\n    return len([0] * 10 ** 6)\n", 2, "list or text"),
    "a list that doubles itself": (
        "def force(overlap):\n    x = [1]\n    for k in range(20):\n        x += x\n    return 1\n",
        4, "list or text"
    ),
    "a wide text": ("def force(overlap):\n    x = '%100000d' % 1\n    return 1\n", 2, "too wide"),
    "a wide field": ("def force(overlap):\n    x = f'{1:100000}'\n    return 1\n", 2, ":100000"),
    "a reckoned width": ("def force(overlap):\n    x = f'{1:{9}}'\n    return 1\n", 2, ":{*}"),
    "a filled text": ("def force(overlap):\n    return len('a'.ljust(10 ** 6))\n", 2, "ljust"),
    "a factorial": (
        "import math\ndef force(overlap):\n    math.factorial(2000)\n    return 1\n", 3, "number"
    ),
    "a product": (
        "from math import prod\ndef force(overlap):\n    prod(range(1, 2000))\n    return 1\n",
        3, "number"
    ),
    "rounded to nothing": (
        "def force(overlap):\n    return round(5, -10 ** 5)\n", 2, "whole number"
    ),
    "a lambda that calls itself twice": (
        "f = lambda n: f(n - 1) + f(n - 1) if n else 1\ndef force(overlap):\n    return f(16)\n",
        1, "goes on and on"
    ),
    "a deep nest": (f"def force(overlap):\n    return {'+'.join('1' * 2000)}\n", 1, "longer"),
    "a file": ("def force(overlap):\n    return len(open('x').read())\n", 2, "“open”"),
    "what lies below": ("def force(overlap):\n    return ().__class__\n", 2, "“__class__”"),
    "a try that swallows": (
        "def force(overlap):\n    try:\n        return 1\n    finally:\n        pass\n", 2, "“try”"
    ),
    "a class": ("class A:\n    pass\ndef force(overlap):\n    return 1\n", 1, "“class”"),
    "too long": ("#" * 20_001, 1, "longer"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG_TEXTS)
def test_a_law_that_cannot_be_asked_is_told_with_its_line(name: str) -> None:
    text, line, words = WRONG_TEXTS[name]
    with pytest.raises(WrongLawError) as found:
        Instance(read_law(text)).ask([0.01, 0.1, *[1.0] * (len(ARGUMENTS) - 2)])
    assert found.value.line == line
    assert any(word in found.value.message for word in words.split("|")), found.value.message


def test_bounds_change_nothing_of_what_a_law_reckons() -> None:
    text = """\
seen = [0, [1]]

def force(overlap, side):
    same, n, word, first = seen[1], 3, "ab", "%s: " % side
    seen[1] += [2, 3]
    seen[len(first) - 6] += len(first)
    same *= 2
    seen[1][1:2] *= 3
    n **= 3
    n <<= 2
    word *= 2
    word += word
    force.calls = n
    force.calls *= n
    square = lambda a: a * a
    lengths = len(word) + sum(seen[1]) + seen[0]
    return n % 7 + lengths + square(n) / 7 + overlap * 3 ** 2 + force.calls
"""
    plain: dict[str, Any] = {}
    exec(text, plain)
    law = Instance(read_law(text))
    for overlap in (0.1, 0.3):
        asked: list[Any] = [1.0] * len(ARGUMENTS)
        asked[0], asked[-1] = overlap, "left"
        assert law.ask(asked) == plain["force"](overlap, "left")


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
        stepped(scene, Way(method, 1e-3))
