"""What one event costs when there are many carts: a push that a row of spaced carts hands on.

N equal carts with lively bumpers stand apart; the first runs into the second, and so on: N − 1
contacts, each with a touch and a parting, in closed form. A solver that looks at all pairs after
each event would take time in proportion to N for each; one with a calendar of events looks at two.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.dynamics.cost.measure import seconds
from sim.dynamics.loop.run import run
from sim.scene import Scene, read_scene

GAP, LENGTH, SPEED = 0.10, 0.10, 1.0
STIFF = 1e5
"""N/m, for 1 kg: a contact takes 7 ms of the 100 ms between two."""


@dataclass(frozen=True, slots=True)
class EventCost:
    """`seconds` of one event, touch or parting, in a row of `carts`."""

    carts: int
    events: int
    seconds: float


def handed_on(count: int) -> Scene:
    """The scene, at least two carts."""
    carts = {
        f"c{k}": {"mass": 1, "position": k * (GAP + LENGTH), "length": LENGTH} for k in range(count)
    }
    carts["c0"]["velocity"] = SPEED
    until = count * (GAP / SPEED + math.pi * math.sqrt(0.5 / STIFF))
    contact = {"law": "bumper", "restitution": 1, "stiffness": STIFF}
    return read_scene({"carts": carts, "contact": contact, "until": until})


def event_cost(count: int) -> EventCost:
    """Measure it: the best of several runs that keep nothing but the outcome."""
    scene = handed_on(count)
    counts = dict(run(scene, keep_motion=False).record.counts)
    events = counts.get("contact", 0) + counts.get("separate", 0)
    taken = min(
        seconds(lambda: run(scene, keep_events=False, keep_motion=False))
        for _ in range(3 if count < 1_000 else 1)
    )
    return EventCost(count, events, taken / events)
