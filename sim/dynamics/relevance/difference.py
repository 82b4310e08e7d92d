"""Where two runs of nearly the same scene differ most, measured on the graph that shows it.

Both are looked at up to where the shorter one ends. Places are compared at the same times; they
never jump. Velocities are compared after the same contact of both runs, and at the end those of
carts that have had the same contacts by then: a contact a moment later is no other velocity. Both
are told as parts of their graph's height, which goes from the least to the greatest value, nought
included.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

from sim.dynamics.result.finished import Run
from sim.dynamics.result.trajectory import sample

INSTANTS = 12
"""Equal parts of a run at whose ends places are compared: differences grow slowly between."""

MOST_CONTACTS = 40
"""Contacts whose velocities are compared: what differs does so before that many."""

READS = 0.01
"""Reading accuracy of a graph, of its height: 1.3 of the 134 units of a drawn graph, less than the
width of its curves. Two runs that are nearer than this have one curve."""

ROUNDING = 1e-12
"""Of a graph's height. Less than this is what arithmetic leaves of nothing."""

Met = dict[str, tuple[Counter[tuple[str, ...]], set[tuple[str, ...]]]]
"""By cart."""

Speeds = dict[tuple[str, tuple[str, ...], int], tuple[float, dict[str, float]]]


@dataclass(frozen=True, slots=True)
class Seen:
    """What is looked at of one run, and the heights of its two graphs [m], [m/s].

    `after` are contacts of all of the run, the rest is up to `times[-1]`: `places` [m] are those at
    `times` [s], `v` [m/s] the velocities at the last of them, `met` what has happened to each cart
    by then.
    """

    names: tuple[str, ...]
    times: tuple[float, ...]
    places: tuple[tuple[float, ...], ...]
    v: tuple[float, ...]
    met: Met
    after: Speeds
    heights: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Difference:
    """The greatest change: of ``x.A`` [m] or ``v.A`` [m/s], when, and as part of the graph."""

    quantity: str
    at: float
    amount: float
    relative: float  # inf: on a graph that shows nothing else

    @property
    def visible(self) -> bool:
        """Does a graph of ordinary size show it?"""
        return self.relative > READS

    @property
    def nothing(self) -> bool:
        """Is it rounding alone?"""
        return self.relative <= ROUNDING


def seen(run: Run, until: float) -> Seen:
    """A run that kept motion and events, looked at up to `until` s, at equally spaced times."""
    times = (*(until * k / INSTANTS for k in range(1, INSTANTS)), until)
    sampled = [sample(run, t) for t in times[:-1]]
    end = (run.x, run.v) if until >= run.t else sample(run, until)
    sampled.append((list(end[0]), list(end[1])))
    after = _after_contacts(run)
    carts = run.scene.carts
    all_x = [0.0, *(c.position for c in carts), *(x for row, _ in sampled for x in row)]
    all_v = [0.0, *(c.velocity for c in carts), *(v for _, row in sampled for v in row)]
    all_v += [v for _, speeds in after.values() for v in speeds.values()]
    heights = (max(all_x) - min(all_x), max(all_v) - min(all_v))
    return Seen(
        tuple(cart.name for cart in carts),
        times,
        tuple(tuple(x) for x, _ in sampled),
        tuple(sampled[-1][1]),
        _met(run, until),
        after,
        heights,
    )


def _met(run: Run, until: float) -> Met:
    """How often each cart has touched whom up to `until` s, and whom it touches then."""
    found: Met = {cart.name: (Counter(), set()) for cart in run.scene.carts}
    for event in run.record.events:
        for body in event.bodies if event.t <= until else ():
            if body not in found:  # an end of the track
                continue
            touches, pressed = found[body]
            if event.kind == "contact":
                touches[event.bodies] += 1
                if not event.impulse:  # one that lasts
                    pressed.add(event.bodies)
            elif event.kind == "separate":
                pressed.discard(event.bodies)
    return found


def _after_contacts(run: Run) -> Speeds:
    found: Speeds = {}
    count: Counter[tuple[str, ...]] = Counter()
    for event in run.record.events:
        if len(found) == MOST_CONTACTS:
            break
        if event.kind in ("contact", "separate") and event.impulse:
            count[event.bodies] += 1
            found["", event.bodies, count[event.bodies]] = (event.t, event.after)
    return found


def difference(own: Seen, other: Seen) -> Difference:
    """The greatest difference as part of the graphs of `own`; of equal ones the first."""
    return max(
        _differences(own, other),
        key=lambda one: (one.relative, one.amount if one.relative == math.inf else 0.0),
    )


def _differences(own: Seen, other: Seen) -> Iterator[Difference]:
    """That of every place and velocity that is compared, after one of nothing."""
    height_x, height_v = own.heights
    until = own.times[-1]
    yield Difference(f"v.{own.names[0]}", until, 0.0, 0.0)
    for t, mine, theirs in zip(own.times, own.places, other.places, strict=True):
        for name, a, b in zip(own.names, mine, theirs, strict=True):
            yield _part(f"x.{name}", t, abs(a - b), height_x)
    for name, a, b in zip(own.names, own.v, other.v, strict=True):
        if own.met[name] == other.met[name]:
            yield _part(f"v.{name}", until, abs(a - b), height_v)
    for key, (t, speeds) in own.after.items():
        if key in other.after:
            for name, v in speeds.items():
                change = abs(v - other.after[key][1].get(name, v))
                yield _part(f"v.{name}", t, change, height_v)


def _part(quantity: str, at: float, amount: float, height: float) -> Difference:
    relative = amount / height if height else (math.inf if amount else 0.0)
    return Difference(quantity, at, amount, relative)
