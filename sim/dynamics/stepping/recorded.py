"""A stepped run as `carts run` shows it: the same result as an exact one, and what does not add up.

Momentum and energy are measured, not forced: every step adds what each force gave and each damper
took, weighted over the step as the method itself weights its forces. The imbalance, final less all
that the accounts explain, is the method's own error; above nought it made energy from nothing:

    momentum   initial + external + imbalance = final
    energy     initial + work + imbalance = final + warmed
"""

from __future__ import annotations

import math
from array import array
from dataclasses import dataclass

from sim.dynamics.result.body_forces import names
from sim.dynamics.result.finished import Run
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.result.trajectory import Trajectory
from sim.dynamics.stepping import spent
from sim.dynamics.stepping.bumpers import Bumpers
from sim.dynamics.stepping.joint_forces import WALLS
from sim.dynamics.stepping.methods import ADAPTIVE, STEP, MethodChoice, drive, stepper
from sim.dynamics.stepping.pairs import Detail, PerCart
from sim.dynamics.stepping.stepper import LocatedStepper, Stepper
from sim.dynamics.stepping.story import Story
from sim.effects.forces import acting
from sim.scene.model import Scene

MOST_ROWS = 20_000
"""Samples kept; of a longer run every so many steps one."""


@dataclass(frozen=True, slots=True)
class SteppedRun:
    """A run like an exact one, its samples, and what its accounts leave unexplained."""

    run: Run
    choice: MethodChoice
    samples: Trajectory
    steps: int
    evaluations: int

    @property
    def lost_momentum(self) -> float:
        """N s. Final − initial − external."""
        books = self.run.ledger
        return books.momentum_final - books.momentum_initial - books.external

    @property
    def lost_energy(self) -> float:
        """J. Final + warmed − initial − work; above nought the method made energy."""
        books = self.run.ledger
        made = math.fsum(books.works.values())
        return books.energy_final + books.warmed - books.energy_initial - made


def stepped(scene: Scene, choice: MethodChoice, *, keep_events: bool = True) -> SteppedRun:
    """Run a scene step by step; `choice` holds for the whole run."""
    step = choice.step or (scene.until if choice.method in ADAPTIVE else STEP)
    run = stepper(scene, choice)
    recorder = Recorder(scene, choice, run, step, keep_events=keep_events)
    drive(run, scene.until, step)
    return recorder.finish()


class Recorder:
    """Listens to a stepper that stands at its start; `step` [s] is its usual one."""

    def __init__(
        self,
        scene: Scene,
        choice: MethodChoice,
        run: Stepper,
        step: float,
        *,
        keep_events: bool = True,
    ) -> None:
        self.scene, self.choice, self.step, self.run = scene, choice, step, run
        self.run.watch(self.seen)
        self.record = Record(scene, keep_events, keep_motion=True)
        self.story = Story(self.run.field, self.record, isinstance(run, LocatedStepper))
        self.ledger = Ledger(scene)
        self.outside = self.from_outside()
        self.columns = _empty(scene, [p.gap for p in self.run.field.pairs], self.outside)
        self.every = max(1, math.ceil(scene.until / self.step / MOST_ROWS))
        self.count = 0
        self.v = list(self.run.v)
        self._links(first=True)
        a, detail = self._now(0.0)
        self.bumpers = Bumpers(run, self.ledger, detail.push)
        self.ledger.stored_initial = self._stored(detail.push)
        self._row(0.0, a, detail)

    def from_outside(self) -> list[tuple[str, int]]:
        """Kind and cart of everything that acts on single carts."""
        return _outside(self.scene)

    def seen(self, t: float, h: float, forces: list[tuple[float, Detail]]) -> None:
        """A step, or part of one, ended at t."""
        run, ledger = self.run, self.ledger
        weighted = [(h * w, detail) for w, detail in forces]
        impulses = [math.fsum(w * d.push[k] for w, d in weighted) for k in range(len(self.v) + 1)]
        for pair in run.field.pairs:
            linked = math.fsum(
                w * force
                for w, d in weighted
                for (_, gap), force in d.links.items()
                if gap == pair.gap
            )
            self._from_wall(pair.left, pair.right, impulses[pair.gap] + linked)
        for gap, loose in self.story.loose.items():
            loose.impulse += math.fsum(w * d.links.get((loose.kind, gap), 0.0) for w, d in weighted)
        for weight, detail in weighted:
            for (kind, k), force in detail.outside.items():
                ledger.push_from_outside(weight * force, kind)
                if kind != WALLS:
                    ledger.work(kind, weight * force * detail.v[k])
            ledger.dissipate(weight * detail.warming)
            for kind, power in detail.damped.items():
                if power:
                    ledger.work(kind, -weight * power)
        a, detail = self._now(t)
        first = forces[0][1].push if forces else None
        self.story.step(t, h, self.v, run.v, run.s, detail.push, impulses, first)
        self.bumpers.step(run.s, run.v, detail.push, impulses)
        ledger.dissipate(run.impacts.spilled)
        run.impacts.spilled = 0.0
        for blow in run.impacts.blows:
            self.story.blow(t, blow)
            self._from_wall(*blow.sides, blow.impulse)
            if blow.release and blow.let_go is None:
                ledger.work(blow.release, -blow.warmed)
            elif not blow.release:
                ledger.dissipate(blow.warmed)
        run.impacts.blows.clear()
        self.v = list(run.v)
        self.count += 1
        if self.count % self.every == 0 or t >= self.scene.until:
            self._row(t, a, detail)

    def _from_wall(self, left: int | None, right: int | None, impulse: float) -> None:
        if impulse and (left is None or right is None):
            self.ledger.push_from_outside(impulse if left is None else -impulse)

    def _now(self, t: float) -> tuple[PerCart, Detail]:
        """Accelerations and forces at the end of a step: for showing, not counted."""
        run, field = self.run, self.run.field
        assert field.keep is not None
        a = field.accelerations(t, run.s, run.v, self.step)
        field.evaluations -= 1
        return a, field.keep.pop()

    def _row(self, t: float, a: PerCart, detail: Detail) -> None:
        run, columns = self.run, self.columns
        columns[("t",)].append(t)
        for k, cart in enumerate(self.scene.carts):
            for kind, value in (("x", cart.position + run.s[k]), ("v", run.v[k]), ("a", a[k])):
                columns[(kind, cart.name)].append(value)
        for pair in run.field.pairs:
            own = detail.push[pair.gap] + detail.joints.get(pair.gap, 0.0)
            force = own + math.fsum(
                linked for (_, gap), linked in detail.links.items() if gap == pair.gap
            )
            columns[("F", "-".join(self.scene.names_at(pair.gap)))].append(force)
        for kind, k in self.outside:
            name = self.scene.carts[k].name
            columns[("E", kind, name)].append(detail.outside.get((kind, k), 0.0))

    def _stored(self, push: PerCart) -> float:
        """J in the contacts that push."""
        field = self.run.field
        return math.fsum(
            spent.stored(pair, *field.overlap(pair, self.run.s, self.run.v), field.memory[pair.gap])
            for pair in field.pairs
            if push[pair.gap] or pair.gap in field.joined  # a latch holds bumpers without a push
        )

    def _links(self, *, first: bool) -> None:
        field = self.run.field
        for pair in field.pairs:
            for link in pair.links:
                d, _ = field.overlap(pair, self.run.s, self.run.v)
                self.ledger.store(link.kind, link.energy(-d), first=first)
        for release in self.run.impacts.springs:
            self.ledger.store(release.kind, release.energy, first=first)

    def finish(self) -> SteppedRun:
        """The stepper came to the end of the scene: settle the accounts."""
        scene, run, ledger = self.scene, self.run, self.ledger
        self.story.finish(scene.until, run.v)
        ledger.v_final = list(run.v)
        a, detail = self._now(scene.until)
        ledger.stored_final = self._stored(detail.push)
        self._links(first=False)
        evaluations = run.field.evaluations
        kinds = {one.kind for one in acting(scene) if not one.releases()}
        finished = Run(
            scene=scene,
            t=scene.until,
            x=tuple(c.position + s for c, s in zip(scene.carts, run.s, strict=True)),
            v=tuple(run.v),
            a=tuple(a),
            record=self.record,
            ledger=ledger,
            solvers={self.choice.method: evaluations},
            effects=dict.fromkeys(sorted(kinds), evaluations),
            forces=None,
            stopped=None,
        )
        return SteppedRun(finished, self.choice, Trajectory(self.columns), run.steps, evaluations)


def _outside(scene: Scene) -> list[tuple[str, int]]:
    """Kind and cart of every effect that acts on single carts."""
    place = {cart.name: k for k, cart in enumerate(scene.carts)}
    return [(kind, place[name]) for kind, name in names(scene)]


def _empty(
    scene: Scene, gaps: list[int], outside: list[tuple[str, int]]
) -> dict[tuple[str, ...], array[float]]:
    columns: dict[tuple[str, ...], array[float]] = {("t",): array("d")}
    for cart in scene.carts:
        columns.update({(kind, cart.name): array("d") for kind in ("x", "v", "a")})
    columns.update({("F", "-".join(scene.names_at(gap))): array("d") for gap in gaps})
    columns.update({("E", kind, scene.carts[k].name): array("d") for kind, k in outside})
    return columns
