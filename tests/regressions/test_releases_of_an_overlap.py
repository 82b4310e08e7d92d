"""A release that parts bumpers while they overlap: they push no more, until pressed again."""

from __future__ import annotations

import contextlib
import io
from typing import Any

import pytest

from sim.bridge.model_text import model_text
from sim.dynamics.loop.run import run
from sim.dynamics.result.energy_parts import energy_parts
from sim.dynamics.result.trajectory import trajectory
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import Scene, read_scene
from tests.reference.effects import integrate

BESIDE: dict[str, list[dict[str, Any]]] = {
    "nothing": [],
    "a slope that is nearly none": [{"incline": {"angle": 1e-9}}],
    "a slope for one": [{"incline": {"angle": "5 deg", "carts": ["A"]}}],
    "a spring to the wall": [
        {"spring": {"between": ["left", "A"], "stiffness": 50, "length": 0.6}}
    ],
    "a spring across": [{"spring": {"between": ["A", "B"], "stiffness": 5, "length": 0.3}}],
    "drag": [{"drag": {"quadratic": 0.5}}],
}


def scene_with(law: str, e: float, energy: float, beside: list[dict[str, Any]]) -> dict[str, Any]:
    """A has pressed B for 0.1 s when the energy between them is set free."""
    release = {"release": {"between": ["A", "B"], "energy": energy, "at": 0.1}}
    return {
        "carts": {
            "A": {"mass": 1, "position": 0.3, "velocity": 0.5},
            "B": {"mass": 1, "position": 0.5},
        },
        "track": {"left": "wall", "length": 3},
        "contact": {"law": law, "restitution": e, "stiffness": 20},
        "effects": [release, *beside],
        "until": 0.5,
    }


@pytest.mark.parametrize("beside", BESIDE)
@pytest.mark.parametrize(
    ("law", "e"), [("push-only", 1), ("push-only", 0.5), ("paper", 0.5), ("bumper", 0.5)]
)
def test_bumpers_that_a_release_parts_push_no_more(law: str, e: float, beside: str) -> None:
    """By any law, whatever else acts: a slope of 1e-9 made a push-only pair push on."""
    scene = read_scene(scene_with(law, e, 0.1, BESIDE[beside]))
    done = run(scene)
    assert list(done.v) == pytest.approx(list(map(float, integrate(scene).v)), abs=1e-11)
    assert done.ledger.imbalance() < 1e-13


@pytest.mark.parametrize("beside", [{"left", "A"}, {"A", "B"}], ids=["from outside", "across"])
@pytest.mark.parametrize("law", ["push-only", "paper", "bumper"])
def test_bumpers_that_a_release_parts_push_when_they_are_pressed_again(
    law: str, beside: set[str]
) -> None:
    """A spring presses A against B again before their overlap is gone: A does not pass B."""
    length = 0.6 if "left" in beside else 0.0
    between = sorted(beside, key=["left", "A", "B"].index)
    spring = {"spring": {"between": between, "stiffness": 60, "length": length}}
    plain = scene_with(law, 0.5, 1e-5, [spring])
    plain["carts"]["B"]["mass"] = 50
    plain["contact"]["stiffness"] = 2000
    plain["effects"][0]["release"]["at"] = 0.02
    done = run(read_scene(plain))
    assert done.record.counts["contact"] >= 2
    assert done.x[1] - done.x[0] > 0.15
    assert done.ledger.imbalance() < 1e-12


K, OVERLAP, E = 500, 0.02, 0.1
LAWS = [("bumper", 1), ("bumper", 0.5), ("bumper", 0), ("paper", 0.5), ("push-only", 0.5)]
STEPPED = [
    MethodChoice("rk4", step=1e-4),
    MethodChoice("rk4-events", step=1e-3),
    MethodChoice("rk45", rtol=1e-9),
    MethodChoice("adaptive", rtol=1e-9),
]


def squeezed(law: str, e: float, **more: Any) -> Scene:
    """Two carts of 1 kg at rest with 2 cm of overlap, and 0.1 J that are set free at 0.5 s."""
    return read_scene(
        {
            "carts": {"A": {"mass": 1, "position": 1}, "B": {"mass": 1, "position": "1.18"}},
            "contact": {"law": law, "restitution": e, "stiffness": K},
            "effects": [{"release": {"between": ["A", "B"], "energy": E, "at": 0.5}}],
            "until": 1,
        }
        | more
    )


def recoverable(law: str, e: float) -> float:
    """J. k d²/2; of a bumper e² of it."""
    return 0.5 * K * OVERLAP**2 * (e * e if law == "bumper" else 1.0)


def printed(scene: Scene) -> list[float]:
    """x and v of all carts in the last line of the program in plain Python."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(model_text(scene), "program", "exec"), {})
    carts = out.getvalue().splitlines()[-1].split(" | ")[1:]
    return [float(number) for cart in carts for number in cart.split(", ")]


@pytest.mark.parametrize(("law", "e"), LAWS)
def test_what_a_latch_keeps_squeezed_is_stored_until_it_opens_and_warm_from_then_on(
    law: str, e: float
) -> None:
    done, held = run(squeezed(law, e)), recoverable(law, e)
    assert done.v == pytest.approx((-(E**0.5), E**0.5), abs=1e-15)  # E alone moves them
    assert done.ledger.stored_initial == pytest.approx(held, abs=1e-14)
    assert done.ledger.stored_final == 0.0
    assert done.ledger.warmed == pytest.approx(held, abs=1e-14)
    assert done.ledger.imbalance() < 1e-12
    samples = trajectory(done)
    parts, times = energy_parts(done, samples), samples.columns[("t",)]
    opened = len(times) - 1 - list(times)[::-1].index(0.5)  # the second of the two samples there
    for k in range(len(times)):
        before = k < opened
        assert parts["bumpers"][k] == pytest.approx(held if before else 0.0, abs=1e-12 * E)
        assert parts["warmed"][k] == pytest.approx(0.0 if before else held, abs=1e-12 * E)


@pytest.mark.parametrize(("law", "e"), LAWS)
def test_a_latch_that_never_opens_keeps_what_it_holds(law: str, e: float) -> None:
    done = run(squeezed(law, e, until=0.25))
    assert done.ledger.stored_initial == pytest.approx(recoverable(law, e), abs=1e-14)
    assert done.ledger.stored_final == done.ledger.stored_initial
    assert done.ledger.warmed == 0.0


@pytest.mark.parametrize("way", STEPPED, ids=lambda way: way.method)
@pytest.mark.parametrize(("law", "e"), LAWS)
def test_no_stepper_gets_energy_out_of_bumpers_that_a_release_has_parted(
    law: str, e: float, way: MethodChoice
) -> None:
    """They gave ±0.447 m/s, with 0.1 J from nowhere, and no shorter step could cure it."""
    done = stepped(squeezed(law, e), way)
    assert done.run.v == pytest.approx((-(E**0.5), E**0.5), abs=1e-12)
    assert done.run.ledger.warmed == pytest.approx(recoverable(law, e), abs=1e-12)
    assert abs(done.lost_energy) < 1e-12
    assert [event.kind for event in done.run.record.events] == ["release", "end"]


@pytest.mark.parametrize(("law", "e"), LAWS)
def test_the_program_gets_no_energy_out_of_them_either(law: str, e: float) -> None:
    a, b = 1 - 0.5 * E**0.5, 1.18 + 0.5 * E**0.5
    assert printed(squeezed(law, e)) == pytest.approx([a, -(E**0.5), b, E**0.5], abs=2e-4)


def pressed_again(law: str, e: float) -> Scene:
    """C comes from behind and presses A against B, while what the release parted overlaps still."""
    carts = {
        "C": {"mass": 1, "position": "0.67", "velocity": "0.5"},
        "A": {"mass": 1, "position": "1"},
        "B": {"mass": 1, "position": "1.18"},
    }
    release = {"release": {"between": ["A", "B"], "energy": "0.0002", "at": "0.2"}}
    return squeezed(law, e, carts=carts, effects=[release])


@pytest.mark.parametrize("way", STEPPED[:3], ids=lambda way: way.method)
@pytest.mark.parametrize(("law", "e"), [one for one in LAWS if one[1]])
def test_bumpers_pressed_again_get_back_what_they_hold_in_every_account(
    law: str, e: float, way: MethodChoice
) -> None:
    """The exact run, a stepper and the program agree, and both accounts close."""
    scene = pressed_again(law, e)
    true, done = run(scene), stepped(scene, way)
    assert {event.t for event in true.record.events if event.bodies == ("A", "B")} - {0.2}
    assert true.ledger.imbalance() < 1e-12
    near = 2e-3 if way.method == "rk4" else 1e-6  # the force jumps within a step of 1e-4 s
    assert done.run.v == pytest.approx(true.v, abs=near)
    assert done.run.ledger.warmed == pytest.approx(true.ledger.warmed, abs=near)
    assert abs(done.lost_energy) < near
    assert printed(scene)[1::2] == pytest.approx(list(true.v), abs=1e-2)
    warmed = energy_parts(true, trajectory(true))["warmed"]
    assert min(warmed) > -1e-9
    assert warmed[-1] == pytest.approx(true.ledger.warmed, abs=1e-9)


IN_A_ROW = {
    "alone": {"A": (1.0, 0.1, 1.0), "B": (2.0, 0.3, -0.5)},
    "beside a third": {"A": (1.0, 0.1, 1.0), "B": (2.0, 0.3, -0.5), "C": (1.0, 0.5, -0.5)},
}


@pytest.mark.parametrize("energy", [0.001, 0.01, 0.1])
@pytest.mark.parametrize("beyond", ["bumper", "hertz"])
@pytest.mark.parametrize("row", IN_A_ROW)
def test_a_spring_let_go_between_pressed_bumpers_gives_all_its_energy(
    row: str, beyond: str, energy: float
) -> None:
    """½ µ w'² = ½ µ u² + E: elastic bumpers give back what they held, and the spring gives E.

    Its full length may end before the bumpers have cleared: they were pressed in by more than that.
    """
    carts = {
        name: {"mass": m, "position": x, "velocity": v} for name, (m, x, v) in IN_A_ROW[row].items()
    }
    pairs = {"B-C": {"law": beyond, "restitution": 1, "stiffness": 4000}} if "C" in carts else {}
    plain: dict[str, Any] = {
        "carts": carts,
        "contact": {"restitution": 1, "stiffness": 500, "pairs": pairs},
        "effects": [
            {"release": {"between": ["A", "B"], "energy": energy, "at": 0.02, "stiffness": 830}}
        ],
        "until": 1,
    }
    done = run(read_scene(plain))
    given = sum(0.5 * m * v * v for m, _, v in IN_A_ROW[row].values()) + energy
    kept = sum(0.5 * cart["mass"] * v * v for cart, v in zip(carts.values(), done.v, strict=True))
    assert kept == pytest.approx(given, rel=1e-13)
    assert done.ledger.imbalance() < 1e-14
