"""Error and time of every method on one scene, row by row.

Errors are the worst of PHASES runs whose first step is only a part of a step, so that touches fall
at PHASES different places within one: a touch on a round number would flatter. Times are those of
single runs in plain Python that keep nothing but the outcome, as a ratio to the exact outcome,
measured in the same process just before and after. Steps are the run's length over a prime.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from sim.dynamics.cost.distance import endless, far
from sim.dynamics.cost.exact import Exact, exact
from sim.dynamics.loop.run import run
from sim.dynamics.result.finished import Run
from sim.dynamics.result.ledger import kinetic
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.stepping.methods import ADAPTIVE, FIXED, MethodChoice, batch, batchable, outcome
from sim.dynamics.stepping.stepper import Stepper
from sim.laws.lookup import contact_law
from sim.scene.effects import kinds
from sim.scene.model import Scene

PHASES, FEW_PHASES = 64, 8
"""Runs for the worst error: as one numpy batch; and one by one, where events are located."""

LADDER: tuple[tuple[str, tuple[int, ...]], ...] = (
    ("euler", (103, 997, 9973)),
    ("semi-implicit", (61, 103, 211, 997, 9973)),
    ("verlet", (61, 103, 211, 997, 9973)),
    ("yoshida", (19, 61, 103, 211, 997, 9973)),
    ("richardson", (19, 61, 103, 211, 997, 9973)),
    ("rk4", (19, 61, 103, 211, 997, 9973)),
    ("rk4-events", (19, 61, 103, 211, 997)),
)
"""Methods, and the primes that the run's length is divided by."""

TOLERANCES = (1e-6, 1e-9, 1e-12)

TRIES = 5
"""Times that a method and the exact outcome are measured in turn; the best of each counts."""

BATCH = 0.02 if sys.platform == "emscripten" else 0.004
"""s. As many runs are timed together: a browser's clock has ticks of up to a thousandth."""

clock = (
    time.process_time
    if time.get_clock_info("process_time").resolution < 1e-6
    else time.perf_counter
)
"""s. That of this process alone, where it is fine enough: others may use the machine too."""


@dataclass(frozen=True, slots=True)
class CostRow:
    """One method at one step [s] or tolerance; errors in SI, `energy_error` of `Exact.in_play`.

    `energy_error` is that of the energy at the end, of the worst run, with its sign. An error is
    infinite where a run ended beyond all numbers. `delivered`: least and greatest restitution,
    where the scene is one contact of two carts.
    """

    method: str
    step: float | None
    rtol: float | None
    order: int | None
    evaluations: int
    time_ratio: float
    error_v: float | None
    error_x: float | None
    energy_error: float | None
    delivered: tuple[float, float] | None = None
    delivered_e: float | None = None


@dataclass(frozen=True, slots=True)
class NotRun:
    """A method that cannot follow this scene, and why."""

    choice: MethodChoice
    reason: str


def choices(scene: Scene, *, finest: int = 10_000) -> list[MethodChoice]:
    """The rows to measure, from the cheapest of each method on, up to so many steps."""
    listed = [
        MethodChoice(name, step=scene.until / prime)
        for name, primes in LADDER
        for prime in primes
        if prime <= finest
    ]
    return listed + [MethodChoice(name, rtol=rtol) for name in ADAPTIVE for rtol in TOLERANCES]


def cost(scene: Scene, truth: Exact | None = None) -> Iterator[CostRow | NotRun]:
    """All rows: the exact ones first, then method by method, against `truth`; raises UnsolvedError
    where the exact solver itself cannot run the scene."""
    truth = truth or exact(scene)
    yield from exact_rows(scene, truth)
    for choice in choices(scene):
        try:
            yield row(scene, truth, choice)
        except UnsolvedError as error:
            yield NotRun(choice, error.message)


def exact_rows(scene: Scene, truth: Exact) -> list[CostRow]:
    """The exact outcome, which is the unit of time; and the solver for any scene, if another."""
    x, v = truth.outcome()
    first = CostRow("exact", None, None, None, 0, 1.0, None, None, None)
    if not truth.formula and not truth.proved:
        return [first]
    first = replace(first, error_v=far(v, truth.v), error_x=far(x, truth.x))
    if not truth.formula:
        return [first]
    energy = (kinetic(scene, v) - truth.energy) / truth.in_play
    e = _delivered(scene, v)
    first = replace(first, energy_error=energy, delivered=(e, e), delivered_e=e)
    solved = run(scene, keep_events=False, keep_motion=False)

    def general() -> Run:
        return run(scene, keep_events=False, keep_motion=False)

    second = replace(
        first,
        method="exact-run",
        time_ratio=ratio(general, truth.outcome),
        error_v=far(solved.v, truth.v),
        error_x=far(solved.x, truth.x),
        energy_error=(kinetic(scene, solved.v) - truth.energy) / truth.in_play,
    )
    return [first, second]


def row(scene: Scene, truth: Exact, choice: MethodChoice) -> CostRow:
    """Measure one method at one step or tolerance."""
    single = outcome(scene, choice)
    found = _Worst(scene, truth)
    if choice.method in FIXED and batchable(scene):
        import numpy as np

        phases = (np.arange(PHASES) + 0.5) / PHASES
        with np.errstate(all="ignore"):  # a run that blows up: its error says so
            s, v, lanes = batch(scene, choice, phases)
        last = [
            (float(a[k]), float(b[k])) for a, b in zip(s, v, strict=True) for k in range(PHASES)
        ]
        for k in range(PHASES):
            ends = last[k::PHASES]
            memory = [float(m[k]) for m in lanes.field.memory]
            found.see(lanes, [s for s, _ in ends], [v for _, v in ends], memory)
    else:
        count = 1 if choice.rtol else FEW_PHASES
        for k in range(count):
            done = outcome(scene, choice, (k + 0.5) / FEW_PHASES) if choice.step else single
            found.see(done, done.s, done.v, done.field.memory)
    return found.row(
        choice, single.field.evaluations, ratio(lambda: outcome(scene, choice), truth.outcome)
    )


class _Worst:
    """The largest errors so far."""

    def __init__(self, scene: Scene, truth: Exact) -> None:
        self.scene, self.truth = scene, truth
        self.v = self.x = self.energy = 0.0
        self.e: list[float] = []

    def see(self, run: Stepper, s: list[float], v: list[float], memory: list[float]) -> None:
        scene, truth = self.scene, self.truth
        x = [
            cart.position + displacement for cart, displacement in zip(scene.carts, s, strict=True)
        ]
        self.v, self.x = max(self.v, far(v, truth.v)), max(self.x, far(x, truth.x))
        energy = kinetic(scene, v) + _stored(run, s, v, memory) - truth.energy
        error = endless(energy / truth.in_play)
        self.energy = error if abs(error) > abs(self.energy) else self.energy
        if truth.formula:
            self.e.append(_delivered(scene, v))

    def row(self, choice: MethodChoice, evaluations: int, dearer: float) -> CostRow:
        delivered = self.e if all(map(math.isfinite, self.e)) else []
        contact = self.scene.contacts[1] if self.truth.formula else None
        wanted = (contact.restitution or 0.0) if contact is not None else 0.0
        return CostRow(
            choice.method,
            choice.step,
            choice.rtol,
            choice.order,
            evaluations,
            dearer,
            self.v,
            self.x,
            self.energy,
            (min(delivered), max(delivered)) if delivered else None,
            max(delivered, key=lambda e: abs(e - wanted)) if delivered else None,
        )


def ratio(call: Callable[[], object], unit: Callable[[], object]) -> float:
    """Time of `call` over time of `unit`, each the best of several, taken in turn."""
    best, base = math.inf, math.inf
    for _ in range(TRIES):
        base = min(base, seconds(unit))
        best = min(best, seconds(call))
    return best / base


def seconds(call: Callable[[], object]) -> float:
    """One call, by as many as fill BATCH."""
    many, spent = 1, 0.0
    while True:
        start = clock()
        for _ in range(many):
            call()
        spent = clock() - start
        if spent >= BATCH:
            return spent / many
        many = max(2 * many, int(many * BATCH / spent) if spent > 0.0 else 0)


def _stored(run: Stepper, s: list[float], v: list[float], memory: list[float]) -> float:
    """J in contacts that still push, in springs and magnets, and height on an incline."""
    field, total = run.field, run.impacts.latched
    for pair in field.pairs:
        d, rate = field.overlap(pair, s, v)
        law = contact_law(pair.contact)
        if d > 0.0 and law is not None and pair.force is not None:
            pushes = pair.force.push(d, rate, memory[pair.gap])
            total += law.stored(d, rate, memory[pair.gap]) if pushes else 0.0
        total += math.fsum(link.energy(-d) for link in pair.links)
    for forces, displacement in zip(field.body_forces(0.0), s, strict=True):
        total -= math.fsum(
            f.steady * displacement for f in forces if kinds()[f.kind].stores == "place"
        )
    return total


def _delivered(scene: Scene, v: Any) -> float:
    return float((v[1] - v[0]) / (scene.carts[0].velocity - scene.carts[1].velocity))
