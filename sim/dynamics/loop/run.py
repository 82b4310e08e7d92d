"""The run: detect the next event, advance to it, resolve it, record it.

Tier 0, flight, and tier 1, one contact at a time, are closed forms; tier 2, bodies that push each
other together, is a power series; tier 3 an adaptive method for what has neither.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable

from sim.dynamics.loop import contacts as resolve
from sim.dynamics.loop import release as bursts
from sim.dynamics.loop import synchronise as components
from sim.dynamics.loop.simulation import Happenings
from sim.dynamics.result import ledger
from sim.dynamics.result.finished import Run
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.result.record import Record
from sim.dynamics.state.clock import ZERO, Time, elapsed
from sim.scene.model import Scene

MOST_EVENTS = 1_000_000
"""A run stops after this many events unless told otherwise: some scenes have infinitely many."""

STEPS_PER_EVENT = 10
"""A contact of several carts takes a handful of steps; a run that needs ten times as many as it may
have events is one that never ends."""

MOST_STEPS = 100_000
"""Power series steps of one run, half a minute. Very stiff beside very soft takes more."""

Progress = Callable[[float, int], None]
"""Told now and then how far the run is: t [s] and the number of events so far."""

TELL_EVERY = 2048
"""Entries of the calendar between two words of progress."""


def run(
    scene: Scene,
    *,
    max_events: int = MOST_EVENTS,
    keep_events: bool = True,
    keep_motion: bool = True,
    max_steps: int = MOST_STEPS,
    progress: Progress | None = None,
) -> Run:
    """Run a scene exactly. Raises UnsolvedError where no exact solver is at hand."""
    try:
        record = Record(scene, keep_events, keep_motion)
        finished = _Run(scene, max_events, max_steps, record).finish(progress)
    except (OverflowError, ZeroDivisionError, ValueError) as error:
        if isinstance(error, UnsolvedError):
            raise
        raise out_of_range() from error
    if not all(map(math.isfinite, (*finished.x, *finished.v, *finished.ledger.totals()))):
        raise out_of_range()
    if (finished.forces is not None or "power-series" in finished.solvers) and (
        finished.ledger.imbalance() > CLOSES
    ):
        raise out_of_range()
    return finished


CLOSES = 1e-6
"""Of all energies in play. Every run closes its accounts to 1e-12 or so; one that does not has lost
its digits to numbers of very different size, and has no result."""


def out_of_range() -> UnsolvedError:
    """Numbers overflowed: the run has no result, rather than a wrong one."""
    return UnsolvedError(
        "the numbers of this scene are too large or too small to compute with",
        "use values that an air track could have",
        0.0,
        (),
    )


class _Run(Happenings):
    """One run, from its start to its end."""

    def __init__(self, scene: Scene, max_events: int, max_steps: int, record: Record) -> None:
        super().__init__(scene, record)
        self.max_events = max_events
        self.most_steps = min(STEPS_PER_EVENT * max_events, max_steps)
        record.pieces = [[] for _ in scene.carts]
        if self.forces is not None:
            self.start_with_effects()
            return
        for body in self.chain.bodies:
            self.solvers["free-flight"] += 1
            record.piece(body)
        for gap in self.chain.gaps:
            if gap is None:
                continue
            if gap.room < 0.0 and gap.law is not None:
                self.begin(gap, ZERO)
            elif gap.touching is None:
                self.predict(gap, ZERO)

    def start_with_effects(self) -> None:
        """Latches, overlaps at the start, springs and magnets; then all solvers at once."""
        forces = self.forces
        assert forces is not None
        ledger.store(self.ledger, self.chain, first=True)
        for number, release in enumerate(forces.releases):
            bursts.latch(self.chain, release, self.record)
            self.calendar.from_outside(number, release.time)
        for t in forces.switches:
            self.calendar.from_outside(len(forces.releases), t)
        gaps = [gap for gap in self.chain.gaps if gap is not None]
        for gap in gaps:
            if gap.room < 0.0 and gap.law is not None and not gap.joined:
                resolve.touch(gap, ZERO, self.record, self.ledger)
        self.form_again(list(dict.fromkeys(self.chain.bodies)), gaps, ZERO)
        self.solvers["free-flight"] += sum(body.motion is None for body in self.chain.bodies)
        if not self.solvers["free-flight"]:
            del self.solvers["free-flight"]

    def finish(self, progress: Progress | None = None) -> Run:
        """Event after event until the end, or until there were too many."""
        entries, gaps, bodies = self.calendar.entries, self.chain.gaps, self.chain.bodies
        last, count, told = self.end[0], len(gaps), 0
        while entries and entries[0][0] <= last:
            hi, lo, key, turn = heapq.heappop(entries)
            now = (hi, lo)
            void = 0 <= key < count and ((gap := gaps[key]) is None or gap.turn != turn)
            if void or (key < 0 and bodies[-1 - key].turn != turn):
                continue
            if self.happened >= self.max_events or self.steps >= self.most_steps:
                return self.result(now, full=True)
            told += 1
            if progress is not None and told % TELL_EVERY == 0:
                progress(hi, self.happened)
            if key < 0:
                self.step(bodies[-1 - key], now)
            elif key >= count:
                self.from_outside(key - count, now)
            elif gap is not None:
                self.at_gap(gap, now)
        return self.result(self.end, full=False)

    def too_much(self) -> str:
        """What there was too much of."""
        if self.happened >= self.max_events:
            return f"{self.max_events} events"
        return f"{self.steps} short steps of contacts that push each other"

    def result(self, end: Time, *, full: bool) -> Run:
        """Bring everything to the end."""
        scene, record = self.scene, self.record
        bodies = list(dict.fromkeys(self.chain.bodies))
        touching = [gap for gap in self.chain.gaps if gap is not None and gap.solver is not None]
        if touching or self.forces is not None:
            components.settle(bodies, touching, end, record, self.ledger)
        else:
            for body in bodies:
                body.x += body.v * elapsed(body.time, end)
        for gap in touching:
            if gap.touching is not None and gap.law is not None:
                resolve.tell_peak(gap, record)
                stored = gap.law.stored(-gap.room, -gap.rate, gap.memory)
                self.ledger.stored_final += stored
        if self.forces is not None:
            ledger.store(self.ledger, self.chain, first=False)
        x, v = [0.0] * len(scene.carts), [0.0] * len(scene.carts)
        for body in bodies:
            if len(body.carts) == 1:
                x[body.carts[0]], v[body.carts[0]] = body.x, body.v
                continue
            for cart, offset in zip(body.carts, record.offsets(body), strict=True):
                x[cart], v[cart] = body.x + offset, body.v
        self.ledger.v_final = v
        record.end(end[0], v)
        return Run(
            scene=scene,
            t=end[0],
            x=tuple(x),
            v=tuple(v),
            record=record,
            ledger=self.ledger,
            solvers=self.solvers,
            effects=self.forces.used if self.forces is not None else {},
            forces=self.forces,
            stopped=self.too_much() if full else None,
        )
