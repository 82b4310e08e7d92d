"""The run: detect the next event, advance to it, resolve it, record it.

Tier 0, flight, and tier 1, one contact at a time, are closed forms; tier 2, bodies that push each
other together, is a power series; tier 3 an adaptive method for what has neither.
"""

from __future__ import annotations

import gc
import heapq
import math
import re
from collections.abc import Callable

from sim.dynamics.loop import contacts, recontact, release, synchronise
from sim.dynamics.loop.last_accelerations import last_accelerations
from sim.dynamics.loop.simulation import Simulation
from sim.dynamics.result.finished import Run
from sim.dynamics.result.outcome import UnsolvedError, refuse_written
from sim.dynamics.result.record import Record
from sim.dynamics.result.stopped import Stopped
from sim.dynamics.state.clock import ZERO, Time, elapsed
from sim.dynamics.state.loads import Forces
from sim.scene.model import Scene
from sim.scene.said import said

MOST_EVENTS = 1_000_000
"""A run stops after this many events unless told otherwise: some scenes have infinitely many."""

STEPS_PER_EVENT = 10
"""A contact of several carts takes a handful of steps; a run that needs ten times as many as it may
have events is one that never ends."""

MOST_STEPS = 100_000
"""Power series steps of one run, half a minute. Very stiff beside very soft takes more."""

Progress = Callable[[float, int], None]
"""Told now and then how far the run is: t [s] and the number of events so far."""

TELL_EVERY = 64
"""Entries of the calendar between two words of progress: each may be a step that takes milliseconds
here, and a hundred times as long in the page of an old laptop."""


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
    refuse_written(scene)
    # A run keeps what it makes, and drops the rest without circles: to look for circles among a
    # hundred thousand lists of numbers would take a fifth of its time.
    collects = gc.isenabled()
    gc.disable()
    try:
        sim = Simulation(scene, Record(scene, keep_events, keep_motion))
        _start(sim)
        finished = _events(sim, max_events, max_steps, progress)
    except (ArithmeticError, ValueError) as error:
        if not is_of_the_numbers(error):
            raise
        raise out_of_range() from error
    finally:
        if collects:
            gc.enable()
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


OF_NUMBERS = re.compile(r"math domain error|expected a .* input|expected a number|NaN|inf")
"""What Python's ValueErrors say where a number is beyond a function of it (3.14 in more words)."""


def is_of_the_numbers(error: ArithmeticError | ValueError) -> bool:
    """Did an operation fail for the size of its numbers? A list that is too short is our fault."""
    if isinstance(error, UnsolvedError):
        return False
    return isinstance(error, ArithmeticError) or bool(OF_NUMBERS.search(str(error)))


def out_of_range() -> UnsolvedError:
    """Numbers overflowed: the run has no result, rather than a wrong one."""
    return UnsolvedError(
        said("the numbers of this scene are too large or too small to compute with"),
        said("use values that an air track could have"),
        0.0,
        (),
    )


def _start(sim: Simulation) -> None:
    """Everything at rest in time: what acts from the start, and what comes first."""
    sim.record.pieces = [[] for _ in sim.scene.carts]
    if sim.forces is not None:
        _start_with_effects(sim, sim.forces)
        return
    for body in sim.chain.bodies:
        sim.solvers["free-flight"] += 1
        sim.record.piece(body)
    for gap in sim.chain.gaps:
        if gap is None:
            continue
        if recontact.touches_at_start(gap):
            sim.begin(gap, ZERO)
        elif gap.touching is None:
            sim.predictions.gap(gap, ZERO)


def _start_with_effects(sim: Simulation, forces: Forces) -> None:
    """Latches, overlaps at the start, springs and magnets; then all solvers at once."""
    _store(sim, first=True)
    for number, one in enumerate(forces.releases):
        release.latch(sim.chain, one, sim.record, sim.ledger)
        sim.calendar.from_outside(number, one.time)
    for t in forces.switches:
        sim.calendar.from_outside(len(forces.releases), t)
    gaps = [gap for gap in sim.chain.gaps if gap is not None]
    for gap in gaps:
        if recontact.touches_at_start(gap) and not gap.joined:
            contacts.touch(gap, ZERO, sim.record, sim.ledger)
    sim.form_again(list(dict.fromkeys(sim.chain.bodies)), gaps, ZERO, begins=True)
    free = sum(body.motion is None for body in sim.chain.bodies)
    if free:
        sim.solvers["free-flight"] += free


def _store(sim: Simulation, *, first: bool) -> None:
    """Energy in springs and magnets, at the start or at the end; of releases still to come too."""
    for gap in sim.chain.gaps:
        for link in gap.links if gap is not None else ():
            assert gap is not None
            sim.ledger.store(link.kind, link.energy(gap.room), first=first)
    let_go = [loose.of for loose in sim.record.let_go]
    for one in sim.forces.releases if sim.forces is not None else ():
        if one.spring is not None and one not in let_go:
            sim.ledger.store(one.kind, one.energy, first=first)


def _events(sim: Simulation, max_events: int, max_steps: int, progress: Progress | None) -> Run:
    """Event after event until the end, or until there were too many."""
    entries, gaps, bodies = sim.calendar.entries, sim.chain.gaps, sim.chain.bodies
    last, moved, outside, told = sim.end[0], sim.calendar.moved, sim.calendar.outside, 0
    most_steps, hits = min(STEPS_PER_EVENT * max_events, max_steps), sim.strikes.hits
    while entries and entries[0][0] <= last:
        hi, lo, key, turn = heapq.heappop(entries)
        now = (hi, lo)
        gap = None
        if 0 <= key < outside:
            gap = gaps[key if key < moved else key - moved]
        void = gap is not None and gap.turn != turn
        if void or (key < 0 and bodies[-1 - key].turn != turn):
            continue
        if sim.happened >= max_events:
            return _result(sim, now, stopped=Stopped(f"{max_events} events", more=True))
        if hits.endless:
            what = f"{sim.happened} events, without room between what is hit in turn for ever"
            return _result(sim, now, stopped=Stopped(what, more=False))
        if sim.steps >= most_steps:
            what = f"{sim.steps} short steps of contacts that push each other"
            more = most_steps < max_steps
            return _result(sim, now, stopped=Stopped(what, more=more, steps=True))
        told += 1
        if progress is not None and told % TELL_EVERY == 0:
            progress(hi, sim.happened)
        if key < 0:
            sim.motion_ends(bodies[-1 - key], now)
        elif key >= outside:
            sim.from_outside(key - outside, now)
        elif gap is not None:
            sim.at_gap(gap, now)
    return _result(sim, sim.end, stopped=None)


def _result(sim: Simulation, end: Time, *, stopped: Stopped | None) -> Run:
    """Bring everything to the end."""
    scene, record, ledger = sim.scene, sim.record, sim.ledger
    bodies = list(dict.fromkeys(sim.chain.bodies))
    a = last_accelerations(bodies, len(scene.carts), end)
    touching = [gap for gap in sim.chain.gaps if gap is not None and gap.solver is not None]
    if touching or sim.forces is not None:
        synchronise.settle(bodies, touching, end, record, ledger, peaks=True)
    else:
        for body in bodies:
            body.x += body.v * elapsed(body.time, end)
    for gap in sim.chain.gaps:  # also between two that stick to walls, which no solver moves
        if gap is not None and gap.touching is not None and gap.law is not None:
            contacts.tell_peak(gap, record, end, sim.instant)
            ledger.stored_final += gap.law.stored(-gap.room, -gap.rate, gap.memory)
    if sim.forces is not None:
        _store(sim, first=False)
        latched = (gap for gap in sim.chain.gaps if gap is not None)
        ledger.stored_final += math.fsum(map(release.held, latched))
    x, v = [0.0] * len(scene.carts), [0.0] * len(scene.carts)
    for body in bodies:
        if len(body.carts) == 1:
            x[body.carts[0]], v[body.carts[0]] = body.x, body.v
            continue
        for cart, offset in zip(body.carts, record.offsets(body), strict=True):
            x[cart], v[cart] = body.x + offset, body.v
    ledger.v_final = v
    record.end(end[0], v)
    return Run(
        scene=scene,
        t=end[0],
        x=tuple(x),
        v=tuple(v),
        a=a,
        record=record,
        ledger=ledger,
        solvers=sim.solvers,
        effects=sim.forces.used if sim.forces is not None else {},
        forces=sim.forces,
        stopped=stopped,
    )
