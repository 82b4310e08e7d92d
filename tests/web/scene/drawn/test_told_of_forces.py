"""What is said of forces is what acts: at its greatest, on a slope, and to who only listens."""

from __future__ import annotations

from typing import Any

import pytest

from tests.web.scene.given.widget_site import baked, in_node
from tests.web.scene.given.wired import READ, wired

BUMP: dict[str, Any] = {
    "carts": {
        "A": {"mass": 1, "position": 0.4, "velocity": 0.6, "bumper_length": "1 cm"},
        "B": {"mass": 2, "position": 1.0, "bumper_length": "1 cm"},
    },
    "track": {"length": 2.4, "right": "wall"},
    "contact": {"restitution": 0.5, "stiffness": 200},
    "until": 2,
}
PEAK = """const { bareOf, eventSentence, lawsOf } = await import(`${view}/words.js`);
const { header } = opened(data.run);
const event = header.events.find(({ kind }) => kind === "peak");
const told = (forces) => eventSentence(event,
  { decimals: { F: 2, v: 2 }, scale: 1, camera: 0, forces },
  lawsOf(header), bareOf(header), header.track);
give([told(true), told(false)]);"""


def peak(law: str) -> list[str]:
    """What is told of the greatest force, with forces and without."""
    contact = {"law": law, "restitution": 0.5, "stiffness": 200}
    said: list[str] = in_node(READ + PEAK, {"run": wired({**BUMP, "contact": contact})})
    return said


@pytest.mark.parametrize("law", ["paper", "push-only", "push-only-uncorrected", "hertz"])
def test_only_where_the_force_goes_with_the_squeeze_is_its_greatest_the_greatest_squeeze(
    law: str,
) -> None:
    with_forces, without = peak(law)
    assert with_forces.startswith("A and B push hardest: ")
    assert with_forces.endswith("\u00a0N on each.")
    assert without == "A and B push hardest."


def test_the_usual_bumpers_push_hardest_where_they_are_squeezed_the_most() -> None:
    assert peak("bumper")[0].startswith("A and B: bumpers squeezed the most, ")


UPRIGHT = "give([f.verticalNote(opened(data).header), ...f.verticalForces(opened(data), 'A')]);"


def test_on_a_slope_the_support_balances_only_a_part_of_the_weight() -> None:
    flat, weight, _ = in_node(READ + UPRIGHT, wired(BUMP))
    assert flat.startswith("Weight and support are equal and opposite here")
    assert weight["name"].startswith("weight of A: ")
    sloped = wired({**BUMP, "effects": [{"incline": {"angle": "5 deg"}}]})
    note, part, support = in_node(READ + UPRIGHT, sloped)
    assert "only the part of the weight across the track" in note
    assert part["name"].startswith("part of the weight of A, across the track: ")
    along = in_node(
        READ + "give(f.effectForces(opened(data), 'A', 0.1).map(({ name }) => name));", sloped
    )
    assert along == ["part of the weight of A, along the track: force on A by the Earth"]
    assert part["value"] == -support["value"] == pytest.approx(-0.9962 * 9.81, rel=1e-3)


INSTANT = """const { instant } = await import(`${view}/instant.js`);
const seen = { decimals: { F: 2, v: 2, x: 3, t: 3 }, force: 1, velocity: 1 };
give(instant(opened(data.run), data.t, seen, 0, data.forces));"""


def told(t: float, *, forces: bool = True, **changes: Any) -> str:
    """The instant in words."""
    run = wired({**BUMP, **changes})
    said: str = in_node(READ + INSTANT, {"run": run, "t": t, "forces": forces})
    return said.replace("\u00a0", " ")


def greatest(**changes: Any) -> float:
    """When the first two push hardest [s]."""
    _, header, _ = baked({"id": "told", **BUMP, **changes})
    return float(next(event["t"] for event in header["events"] if event["kind"] == "peak"))


def test_who_listens_hears_which_way_each_force_points() -> None:
    said = told(greatest())
    assert "Force on A by B: 6.93 N to the left." in said
    assert "Force on B by A: 6.93 N to the right." in said


def test_who_listens_hears_of_a_hand_and_of_the_track_too() -> None:
    push = {"push": {"cart": "A", "force": "0.50 N"}}
    friction = {"friction": {"coefficient": 0.01}}
    said = told(0.2, effects=[push, friction])
    assert "Force on A by hand: 0.500 N to the right." in said
    assert "Force on A by the track: 0.0981 N to the left." in said


def test_of_a_wall_the_forces_on_both_are_told() -> None:
    alone: dict[str, Any] = {"carts": {"A": {**BUMP["carts"]["A"], "position": 2.0}}}
    said = told(greatest(**alone), **alone)
    assert "Force on A by the wall: 8.49 N to the left." in said
    assert "Force on the wall by A: 8.49 N to the right." in said


def test_hidden_forces_are_not_told_to_who_listens() -> None:
    push = {"push": {"cart": "A", "force": "0.5 N"}}
    assert "orce" not in told(0.2, forces=False, effects=[push])


FEATURES = """const { features } = await import(`${source}/predict/curve-features.js`);
const name = "changes evenly in the first half";
give(data.map((h) => features("v", h, h).find(([one]) => one === name)[1]));"""


def test_what_rises_and_falls_alike_does_not_change_evenly() -> None:
    ramp, hill = [0, 1, 2, 3, 4, 4, 4, 4, 4], [0, 1, 2, 1, 0, 0, 0, 0, 0]
    fall = [-height for height in ramp]
    assert in_node(FEATURES, [ramp, hill, fall]) == [True, False, True]
