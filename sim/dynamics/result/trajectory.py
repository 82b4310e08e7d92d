"""A finished run as columns over one time grid, ready to be drawn.

Two samples for a free flight, dense ones in a contact, and two samples at one time wherever a
force or a velocity jumps, so that nothing is smoothed over: the area under the drawn force is the
change of momentum. Between samples a cubic through values and slopes (x with v, v with a, F with
dF) is accurate to about 1e-8 of the amplitude in a contact and exact in free flight; where damped
balls in a row touch, their force, which starts as the fourth root of the time, to about 1e-4.
"""

from __future__ import annotations

from array import array
from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

from sim.dynamics.result import body_forces
from sim.dynamics.result.body_forces import Outside
from sim.dynamics.result.finished import Run
from sim.dynamics.result.record import Solved
from sim.dynamics.result.stretch import Stretch, state

PER_STRETCH = 16
"""Samples in one stretch of a contact (a quarter swing of a bumper): cubic error below 1e-8."""

MOST_NUMBERS = 150_000
"""Numbers in all columns. A run with more contacts than fit is sampled more thinly in each."""

SHORT_STEPS = 2
"""A nonlinear power series takes steps so short that so many times fewer samples draw them."""

LONG_TIMES = 12.0
"""Time constants after which a contact that never ends has faded below 1e-4 of its start."""


@dataclass(frozen=True, slots=True)
class Trajectory:
    """`columns[name]` are float arrays of one length; names are tuples such as ("x", "A")."""

    columns: dict[tuple[str, ...], array[float]]

    @property
    def rows(self) -> int:
        """Samples in each column."""
        return len(self.columns[("t",)])

    def greatest(self, pair: str) -> float:
        """N. The greatest size of the force between a pair, also where it turns between rows; 0 of
        a pair that nothing pushes."""
        if ("F", pair) not in self.columns:
            return 0.0
        t, F, dF = (self.columns[name] for name in (("t",), ("F", pair), ("dF", pair)))
        most = max(map(abs, F), default=0.0)
        for (begin, end), (low, high), (rises, falls) in zip(
            *map(pairwise, (t, F, dF)), strict=True
        ):
            if rises * falls < 0.0 and end > begin:
                s, h = rises / (rises - falls), end - begin
                r = 1.0 - s
                ends = low * (1.0 + 2.0 * s) * r * r + high * (1.0 + 2.0 * r) * s * s
                most = max(most, abs(ends + h * s * r * (rises * r - falls * s)))
        return most


def trajectory(
    run: Run,
    per_stretch: int = PER_STRETCH,
    per_flight: int = 1,
    at_work: Callable[[], object] | None = None,
) -> Trajectory:
    """Sample a run that kept its motion; fewer samples per stretch make a lighter page.

    `per_flight`: into how many parts a flight is divided in which a steady force acts. `at_work`
    is called after every stretch: of thousands the samples take as long as the run.
    """
    record = run.record
    solved = sorted(record.solved, key=lambda part: (part.begin, part.gaps))
    gaps = sorted(
        {gap for part in solved for gap in part.gaps} | {joint.gap for joint in record.joints}
    )
    named = body_forces.names(run.scene)
    titles = _titles(run, gaps, named)
    dense = min(per_stretch, _density(len(solved), len(titles)))
    starts = [[piece.start[0] for piece in pieces] for pieces in record.pieces]
    live: list[Solved] = []
    numbers: array[float] = array("d")  # row after row
    upcoming, last = 0, None
    marks, outside_at = _marks(run), _outside(run)
    parabola = max(1, min(per_flight, MOST_NUMBERS // (len(titles) * len(marks))))
    for begin, end in pairwise(marks):
        while upcoming < len(solved) and solved[upcoming].begin <= begin:
            live.append(solved[upcoming])
            upcoming += 1
        if at_work is not None:
            at_work()
        middle = 0.5 * (begin + end)
        motion = [
            pieces[bisect_right(times, middle) - 1]
            for pieces, times in zip(record.pieces, starts, strict=True)
        ]
        # At an instant, the first or the last of a run, what moves a cart from there on is drawn.
        moving = {id(piece.motion) for piece in motion} if begin == end else set()
        live = [part for part in live if part.end > begin or id(part.solver) in moving]
        stuck = {joint.gap for joint in record.joints if joint.begin <= begin < joint.end}
        steady = any(piece.motion is not None for piece in motion)
        stretch = Stretch(run, motion, live, gaps, stuck, named, outside_at(middle))
        for t in _times(begin, end, live, dense, parabola if steady else 1):
            row = stretch.row(t)
            if row != last:
                numbers.extend(row)
                last = row
    return Trajectory({title: numbers[k :: len(titles)] for k, title in enumerate(titles)})


def _titles(run: Run, gaps: list[int], named: list[tuple[str, str]]) -> list[tuple[str, ...]]:
    """Names of the columns."""
    titles: list[tuple[str, ...]] = [("t",)]
    titles += [(kind, cart.name) for cart in run.scene.carts for kind in ("x", "v", "a")]
    pairs = ["-".join(run.scene.names_at(gap)) for gap in gaps]
    titles += [(kind, pair) for pair in pairs for kind in ("F", "dF")]
    return titles + [("E", kind, name) for kind, name in named]


def _outside(run: Run) -> Callable[[float], Outside]:
    """What acts on single carts just after t s: a push that begins there counts already."""
    forces, carts = run.forces, run.scene.carts
    places = range(len(carts))
    if forces is None:
        nothing = Outside(carts, [[] for _ in places], [None for _ in places])
        return lambda t: nothing
    grips = [forces.friction_on(k) for k in places]
    return lambda t: Outside(carts, [forces.on_cart(k, t) for k in places], grips)


def _marks(run: Run) -> list[float]:
    """Times at which some motion changes its formula, both ends included."""
    marks = {0.0, run.t}
    for part in run.record.solved:
        marks.update((part.begin, part.end))
        marks.update(
            t
            for mark in part.solver.marks(part.end - part.begin)
            if (t := part.begin + mark) < part.end
        )
    for pieces in run.record.pieces:
        marks.update(piece.start[0] for piece in pieces)
    kept = sorted(t for t in marks if t <= run.t)
    told = (event for event in run.record.events if event.t == run.t)
    jumps = any(event.before != event.after for event in told)
    return [*kept, run.t] if jumps or len(kept) == 1 else kept  # or stopped at the very start


def _density(contacts: int, columns: int) -> int:
    """Samples per stretch that keep the whole within MOST_NUMBERS."""
    if contacts == 0:
        return PER_STRETCH
    return max(2, min(PER_STRETCH, MOST_NUMBERS // (columns * 2 * contacts)))


def _times(begin: float, end: float, live: list[Solved], dense: int, parabola: int) -> list[float]:
    """Sample times from begin to end, both included."""
    live = [part for part in live if not part.solver.parabolic]
    if not live:
        return [*(begin + (end - begin) * k / parabola for k in range(parabola)), end]
    count = dense
    if all(part.solver.short_steps for part in live):
        count = max(2, dense // SHORT_STEPS)
    span = end - begin
    fade = [rate for part in live for rate in part.solver.fading]
    quick = max((max(rate.w0, rate.beta + rate.w) for rate in fade), default=0.0)
    if quick * span > LONG_TIMES:  # a long fading tail: equal steps first, then longer and longer
        early = LONG_TIMES / quick
        steps = [early * k / (2 * dense) for k in range(2 * dense)]
        growth = (span / early) ** (1.0 / dense)
        steps += [early * growth**k for k in range(dense)]
        return [*(begin + s for s in steps if s < span), end]
    if fade:
        count = 2 * dense  # one stretch covers the whole contact
    return [*(begin + span * k / count for k in range(count)), end]


def sample(run: Run, t: float) -> tuple[list[float], list[float]]:
    """x [m] and v [m/s] of every cart at one time, exactly (after a jump at t, if there is one)."""
    x, v = [], []
    for pieces in run.record.pieces:
        k = bisect_right(pieces, t, key=lambda piece: piece.start[0]) - 1
        place, speed, _ = state(pieces[max(k, 0)], t)
        x.append(place)
        v.append(speed)
    return x, v
