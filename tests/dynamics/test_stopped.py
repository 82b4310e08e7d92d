"""What a run that was stopped says would help: nothing that cannot."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.result.stopped import Stopped
from sim.dynamics.stepping.adaptive_events import AdaptiveStepper
from sim.scene import Scene, read_scene


def two(contact: dict[str, Any], masses: tuple[float, float] = (1, 1), **more: Any) -> Scene:
    carts = {
        name: {"mass": mass, "position": x, "velocity": v}
        for name, mass, x, v in zip("AB", masses, (0.2, 0.5), (1, -1), strict=True)
    }
    walls = {"left": "wall", "right": "wall", "length": 1}
    return read_scene({"carts": carts, "track": walls, "contact": contact, "until": 600, **more})


EVENTS = Stopped("3000 events", more=True)
STEPS = Stopped("9000 short steps of contacts that push each other", more=False, steps=True)
INSTANT = {"law": "instant", "restitution": 1}
PAPER = {"law": "paper", "restitution": 0.5, "stiffness": 500}
SPRING = {"spring": {"between": ["A", "B"], "stiffness": 10, "length": 0.3}}


def test_without_loss_no_larger_restitution_helps() -> None:
    assert "restitution" not in EVENTS.sentence(two(INSTANT), 1)
    assert "restitution" not in EVENTS.sentence(two({"law": "velcro"}), 1)
    assert "a larger restitution" in EVENTS.sentence(two(PAPER), 1)
    mixed = INSTANT | {"pairs": {"A-B": {"law": "instant", "restitution": 0.9}}}
    assert "a larger restitution" in EVENTS.sentence(two(mixed), 1)


def test_only_what_differs_is_to_differ_less() -> None:
    assert "differ" not in EVENTS.sentence(two(PAPER), 1)
    assert "or masses that differ less." in EVENTS.sentence(two(INSTANT, (1, 9)), 1)
    led = two(PAPER, effects=[SPRING])
    assert "or stiffnesses that differ less." in EVENTS.sentence(led, 1)
    both = two(PAPER, (1, 9), effects=[SPRING])
    assert "or stiffnesses and masses that differ less." in STEPS.sentence(both, 1)


def test_more_events_are_no_help_where_steps_were_counted() -> None:
    assert STEPS.sentence(two(PAPER), 1.5) == (
        "The run was stopped at t = 1.5 s after 9000 short steps of contacts that push each other. "
        "Ask for an earlier end (until), a larger restitution, or a smaller stiffness."
    )


def test_no_end_is_earlier_than_the_start() -> None:
    assert EVENTS.sentence(two(INSTANT), 0) == (
        "The run was stopped at t = 0 s after 3000 events. Ask for more events (--max-events)."
    )


@pytest.mark.parametrize(
    ("limits", "helps"), [({"max_steps": 20}, False), ({"max_events": 3}, True)]
)
def test_a_run_says_which_of_its_limits_it_met(limits: dict[str, int], helps: bool) -> None:
    scene = two(PAPER, effects=[SPRING, {"drag": {"quadratic": 0.1}}])
    done = run(scene, **limits)
    assert done.outcome.kind == "too-many-events"
    assert ("more events (--max-events)" in done.outcome.sentence) is helps


def test_what_is_hit_for_ever_without_room_is_told_to_leave_some() -> None:
    carts = {
        "A": {"mass": 1, "position": 0.1, "velocity": 1},
        "B": {"mass": 1, "position": 0.3},
    }
    walls = {"left": "wall", "right": "wall", "length": 0.4}
    scene = {"carts": carts, "track": walls, "contact": INSTANT, "until": 2}
    done = run(read_scene(scene), max_events=50_000)
    assert done.outcome.sentence.endswith("Ask for room between those that touch.")
    carts["B"]["position"] = 0.31
    walls["length"] = 0.42
    assert run(read_scene(scene), max_events=50_000).stopped is None


@pytest.mark.parametrize(
    ("contact", "hint"),
    [(PAPER, "a softer contact, or a larger --rtol"), (INSTANT, "a larger --rtol")],
)
def test_no_contact_is_to_be_softer_where_none_has_a_stiffness(
    contact: dict[str, Any], hint: str
) -> None:
    failed = SimpleNamespace(step=lambda: None, status="failed", t=0.5)
    with pytest.raises(UnsolvedError) as refused:
        AdaptiveStepper(two(contact))._one(failed)
    assert refused.value.hint == hint
