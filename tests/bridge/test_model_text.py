"""The plain program of a scene comes to the same end as the exact run, with nothing but Python."""

from __future__ import annotations

import ast
import math
import sys

import pytest

from sim.bridge.model_text import MOST_STEPS, model_text
from sim.bridge.protocol import answer
from sim.dynamics.loop.run import run
from sim.scene import read_scene
from sim.scene.laws import laws
from tests import registry
from tests.bridge.plain_program import played

NEAR = 0.02
"""Of the fastest cart: first order, a hundred steps in a quarter swing."""

NEAR_ALONE = 0.003
"""m/s, of a single contact at 1 m/s: a force that is another one is off by ten times as much."""

LONG = 400_000
"""Steps; scenes with more are compiled, and not run."""


@pytest.mark.parametrize("name", registry.NAMES)
def test_the_plain_program_ends_as_the_run_does(name: str) -> None:
    scene = registry.scene(name)
    text = model_text(scene)
    imported = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ImportFrom)]
    assert {node.module for node in imported} <= set(sys.stdlib_module_names)
    exact = run(scene, keep_motion=False)
    program = played(text.split("\nprint(")[0])
    if scene.until / float(program["dt"]) > LONG:  # type: ignore[arg-type]
        return
    program = played(text)
    fastest = max(*map(abs, exact.v), *(abs(c.velocity) for c in scene.carts), 1e-3)
    for got, expected in zip(program["v"], exact.v, strict=True):  # type: ignore[arg-type]
        assert got == pytest.approx(expected, abs=NEAR * fastest), name


@pytest.mark.parametrize("e", [0, 0.2, 0.5, 0.9, 1])
@pytest.mark.parametrize("law", laws())
def test_the_program_of_each_law_gives_back_as_much_as_the_law(law: str, e: float) -> None:
    """1 kg at 1 m/s into 2 kg: what it gives back is where forms of one force differ most."""
    kind = laws()[law]
    contact: dict[str, object] = {"law": law}
    if kind.restitution is not None:
        contact["restitution"] = e
    if kind.stiffness is not None:
        contact["stiffness"] = 5000
    carts = {
        "A": {"mass": 1, "position": 0.5, "velocity": 1},
        "B": {"mass": 2, "position": 1},
    }
    plain = {"carts": carts, "contact": contact, "until": 1}
    if kind.no_zero and e == 0:
        return
    scene = read_scene(plain)
    program = played(model_text(scene))
    assert program["v"] == pytest.approx(run(scene).v, abs=NEAR_ALONE)


@pytest.mark.parametrize("at", [1.0, 1.00013])
@pytest.mark.parametrize("lasts", [0.004, 1e-4])
def test_a_push_gives_all_its_impulse_however_short_beside_a_step(at: float, lasts: float) -> None:
    plain = {
        "carts": {"A": {"mass": 0.5, "position": 0.5}},
        "effects": [{"push": {"cart": "A", "force": 10, "from": at, "until": at + lasts}}],
        "until": 60,
    }
    (v,) = played(model_text(read_scene(plain)))["v"]  # type: ignore[misc]
    assert v == pytest.approx(10 * lasts / 0.5, rel=1e-9)


TWO = {
    "A": {"mass": 0.01, "position": 0.5, "velocity": 2},
    "B": {"mass": 0.03, "position": 1.0},
}
MU = 0.0075  # kg
QUICK: dict[str, tuple[dict[str, object], float]] = {
    "drag": ({"drag": {"linear": 50, "quadratic": 75}}, 0.01 / (50 + 75 * 2)),
    # C/(2 r²) = ½ μ u² at r = 1 mm; there 1/w² = μ r⁴/(3 C)
    "magnets": (
        {"magnets": {"between": ["A", "B"], "strength": 3e-8, "power": 3}},
        math.pi / 2 * math.sqrt(MU * 1e-3**4 / 9e-8),
    ),
    "a spring's damper": (
        {"spring": {"between": ["A", "B"], "stiffness": 1, "length": 0.4, "damping": 150}},
        0.005 / 150,
    ),
}


@pytest.mark.parametrize(("effect", "takes"), QUICK.values(), ids=QUICK)
def test_a_hundred_steps_are_as_long_as_what_the_quickest_effect_takes(
    effect: dict[str, object], takes: float
) -> None:
    text = model_text(read_scene({"carts": TWO, "effects": [effect], "until": 0.5}))
    dt = float(played(text.split("\nprint(")[0])["dt"])  # type: ignore[arg-type]
    assert 100 * dt == pytest.approx(takes, rel=0.05)


@pytest.mark.parametrize(("until", "near"), [(1, True), (1000, False)])
def test_a_program_with_too_long_steps_says_so(until: float, near: bool) -> None:
    contact = {"stiffness": 1e6, "restitution": 0.9}
    text = model_text(read_scene({"carts": TWO, "contact": contact, "until": until}))
    assert ("nearly right" in text) == near
    assert ("Do not trust its numbers" in text) == (not near)


@pytest.mark.parametrize("law", ["paper", "push-only", "hertz"])
def test_what_sticks_together_meets_a_wall_as_one_in_the_program_too(law: str) -> None:
    """Its damper is that of both masses: it gives back as much as it says of their common speed."""
    contact = {"law": law, "restitution": 0.6, "stiffness": 5000}
    carts = {
        "A": {"mass": 0.5, "position": 0.4, "velocity": 0.9},
        "B": {"mass": 1, "position": 0.8},
    }
    plain = {
        "carts": carts, "track": {"right": "wall", "length": 1.2}, "until": 2.5,
        "contact": contact | {"pairs": {"A-B": {"law": "velcro"}}},
    }  # fmt: skip
    program = played(model_text(read_scene(plain)))
    assert program["v"] == pytest.approx((-0.18, -0.18), abs=0.3 * NEAR_ALONE)


def test_a_program_holds_only_what_its_scene_calls_for() -> None:
    plain = model_text(registry.scene("light-meets-heavy"))
    for word in ("friction", "springs", "magnets", "slopes", "drags", "pushes", "releases"):
        assert word not in plain
    assert "stiffness / e**2" in plain
    assert "rough" in model_text(registry.scene("release-and-friction"))
    assert "damper is that of all" not in plain + model_text(registry.scene("sticky"))


def test_a_page_asks_for_the_program_of_the_values_it_shows() -> None:
    plain = {
        "carts": {"A": {"mass": 1, "position": 0.5, "velocity": 1}, "B": {"position": 1.5}},
        "until": 2,
    }
    plain["carts"]["B"]["mass"] = 2  # type: ignore[index]
    header, numbers = answer({"id": 1, "kind": "model", "scene": plain, "set": {"A.mass": 3}})
    assert header["ok"] and len(numbers) == 0
    assert "mass = [3.0, 2.0]" in header["text"]
    refused, _ = answer({"id": 2, "kind": "model", "scene": {"carts": 3}})
    assert not refused["ok"]


def test_a_law_in_a_file_is_refused_with_a_reason() -> None:
    law = "def force(gap, closing, mass):\n    return 0.0\n"
    plain = {
        "carts": {
            "A": {"mass": 1, "position": 0.5, "velocity": 1},
            "B": {"mass": 1, "position": 2},
        },
        "contact": {"law": "mine.py", "stiffness": 100},
        "laws": {"mine.py": law},
    }
    refused, _ = answer({"id": 1, "kind": "model", "scene": plain})
    (problem,) = refused["problems"]
    assert problem["code"] == "unsolved"


def test_the_longest_program_ends_within_seconds() -> None:
    stiff = read_scene(
        {"carts": {"A": {"mass": 1, "position": 0.5, "velocity": 1}}, "track": {"right": "wall",
         "length": 2}, "contact": {"stiffness": 1e12}, "until": 100}
    )  # fmt: skip
    program = played(model_text(stiff).split("\nprint(")[0])
    assert math.ceil(100 / float(program["dt"])) <= 1.1 * MOST_STEPS  # type: ignore[arg-type]
