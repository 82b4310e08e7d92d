"""Touches in stepped runs: none is missed, each is told at its time, and what sticks is one."""

from __future__ import annotations

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.events import Event
from sim.dynamics.stepping.methods import ADAPTIVE, FIXED, MethodChoice
from sim.dynamics.stepping.recorded import stepped
from sim.scene import Scene, read_scene
from tests import registry

LOCATED = ("rk4-events", *ADAPTIVE)
DIVERGES = {"euler"}
"""It makes energy in every stiff contact: see `test_stepping`."""

TOUCHED = [
    "dead-stop", "equal-swap", "friction-and-bumper", "off-the-wall", "paper-two-carts",
    "push-a-train", "push-only", "train-of-five", "triple-hit",
]  # fmt: skip


def way(method: str, scene: Scene, parts: int = 997) -> MethodChoice:
    """So many steps, or a tolerance."""
    return (
        MethodChoice(method, rtol=1e-9)
        if method in ADAPTIVE
        else MethodChoice(method, step=scene.until / parts)
    )


def touches(events: list[Event]) -> list[Event]:
    return [event for event in events if event.kind in ("contact", "separate")]


@pytest.mark.parametrize("method", LOCATED)
@pytest.mark.parametrize("name", TOUCHED)
def test_located_steps_tell_touches_when_they_happen(name: str, method: str) -> None:
    """Not a step later; and the force is that of the touch, and of the parting."""
    scene = registry.scene(name)
    true, near = touches(run(scene).record.events), 1e-7 if method in ADAPTIVE else 5e-5
    mine = touches(stepped(scene, way(method, scene)).run.record.events)
    assert true and [(e.kind, e.bodies) for e in mine] == [(e.kind, e.bodies) for e in true]
    assert [e.t for e in mine] == pytest.approx([e.t for e in true], abs=near * scene.until)
    for event, exact in zip(mine, true, strict=True):
        assert event.force == pytest.approx(exact.force, abs=1e-4)
        assert event.after == pytest.approx(exact.after, abs=2e-4)


@pytest.mark.parametrize("method", LOCATED)
def test_a_touch_that_a_step_is_too_long_to_show_is_found(method: str) -> None:
    """A soft spring has nearly stopped A when it knocks at the wall, for 2 ms in steps of 0.1 s."""
    scene = read_scene(
        {
            "carts": {"A": {"mass": 1, "position": "0.5", "velocity": "0.3"}},
            "track": {"right": "wall", "length": "1"},
            "contact": {"law": "bumper", "restitution": 1, "stiffness": 2_000_000},
            "effects": [
                {"spring": {"between": ["A", "right"], "stiffness": "0.5", "length": "0.4"}}
            ],
            "until": 3,
        }
    )
    touch, parting = touches(run(scene).record.events)
    assert parting.t - touch.t < 0.003
    done = stepped(scene, way(method, scene, parts=30)).run
    told = touches(done.record.events)
    assert told[0].t == pytest.approx(touch.t, abs=1e-4)
    if method in ADAPTIVE:  # the other's step is too long for what follows, too
        assert told[1].t == pytest.approx(parting.t, abs=1e-6)
        assert done.v == pytest.approx(run(scene).v, abs=1e-6)


@pytest.mark.parametrize("method", sorted({*FIXED, *LOCATED} - DIVERGES))
@pytest.mark.parametrize("law", ["paper", "push-only"])
def test_what_sticks_together_meets_a_wall_as_one(law: str, method: str) -> None:
    """A damper is that of all the mass behind it: both give back e of their common speed."""
    contact = {"law": law, "restitution": "0.6", "stiffness": 400}
    scene = read_scene(
        {
            "carts": {
                "A": {"mass": "0.5", "position": "0.4", "velocity": "0.9"},
                "B": {"mass": 1, "position": "0.8"},
            },
            "track": {"right": "wall", "length": "1.2"},
            "contact": contact | {"pairs": {"A-B": {"law": "velcro"}}},
            "until": 3,
        }
    )
    done = stepped(scene, way(method, scene, parts=6007)).run
    assert done.v == pytest.approx((-0.18, -0.18), abs=1e-6 if method in LOCATED else 1e-3)
    assert done.v == pytest.approx(run(scene).v, abs=1e-6 if method in LOCATED else 1e-3)


@pytest.mark.parametrize("method", LOCATED)
def test_what_lies_idle_in_an_overlap_is_given_back_where_it_is_pressed_again(method: str) -> None:
    """With e = 0.05 they let go long before they are clear, and a push presses them once more."""
    scene = read_scene(
        {
            "carts": {
                "A": {"mass": 5, "position": "0.1"},
                "B": {"mass": "1.5", "position": "0.29", "velocity": -1},
            },
            "track": {"left": "wall"},
            "contact": {"law": "push-only", "restitution": "0.05", "stiffness": 2200},
            "start": {"overlap": True},
            "effects": [{"push": {"cart": "B", "force": -1, "until": 1}}],
            "until": 2,
        }
    )
    true, done = run(scene), stepped(scene, way(method, scene, parts=3001))
    assert true.record.counts["contact"] > 3
    assert done.run.ledger.warmed == pytest.approx(true.ledger.warmed, abs=1e-5)
    assert abs(done.lost_energy) < 1e-5
