"""A scene followed through a world: located steps of RK4, as long as what happens allows.

Where nothing touches a step is a part of the run, in a contact a part of its swing, 1/(ω √2): a
push may be twice the law's. What slows a cart down, v' = −λ v + …, shortens the step too: first so
that λ⁵ h⁵/120 of what still fades, |v'|/λ, is nought, and always so that λ h stays in reach of RK4,
which runs away from λ h = 2.78 on. Every touch and every separation ends a step. One contact of a
bumper alone has a closed form also here (that of carts of mass m/α): the tests hold it to that.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from sim.dynamics.result.finished import Run
from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.result.trajectory import Trajectory
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.pairs import Detail, PerCart
from sim.dynamics.stepping.sided import OwnSteps, Side, SidedRecorder
from sim.laws.lookup import contact_law
from sim.scene.model import Scene
from sim.scene.said import said
from sim.worlds.describe import World
from sim.worlds.field import WorldField
from sim.worlds.force import Impossible, at_work

PARTS = 250
"""Steps of a run in which nothing touches, at least."""

SWING = 1 / 40
"""Of 1/ω. RK4 is off by some 1e-10 of the amplitude in each swing."""

LATE = 1 / 2
"""Of that, where a late force is read off between the ends of steps: 1e-5 of an impulse."""

FADING = 1e-10
"""m/s. Error of one step while a velocity fades; some 200 of them make a fading."""

REACH = 2.0
"""Of 1/λ. The longest step where nothing fades any more: each leaves a third of what is there."""

MOST = 200_000
"""Steps of one run: some seconds."""


@dataclass(frozen=True, slots=True)
class WorldRun:
    """A run of something impossible: the scene as its author wrote it, the run, its samples."""

    scene: Scene
    world: World
    run: Run
    samples: Trajectory


class WorldStepper(OwnSteps):
    """Steps as long as the stiffest contact just now allows."""

    def __init__(self, scene: Scene, name: str, world: Impossible) -> None:
        self.world, self.name = world, name
        self.now = 0.0  # s, the end of the last step
        self.late: list[float] = []  # s, when a push comes back that has jumped
        super().__init__(scene)

    def make_field(self, scene: Scene, lanes: int) -> WorldField:
        """With the world's own forces."""
        self.own = WorldField(scene, self.name, self.world)
        return self.own

    def length(self, t: float) -> float:
        """s. The next step."""
        whole = min(self.field.scene.until / PARTS, self._fading(t))
        late = self.world.delay > 0.0
        least = min((self._swing(gap) for gap in self._pressed()), default=whole)
        if late and self.own.echoes(t):
            least = min((self._swing(pair.gap) for pair in self.field.pairs), default=whole)
        if late and self.own.begun:
            least = min(least, self.world.delay / LATE)  # what a step reads off lies before it
        return min(whole, least * LATE if late else least)

    def spent(self) -> bool:
        """Too many steps."""
        return self.steps >= MOST

    def lost(self, t: float) -> UnsolvedError:
        """Of a world there is no other way than steps."""
        message = said("this world does not come to its end")
        return UnsolvedError(message, said("a shorter run (until)"), t, ())

    def _fading(self, t: float) -> float:
        """s. What the velocities allow that something slows down."""
        rates = self._rates(t)
        if not any(rates):
            return math.inf
        total, least = self.field.forces(t, self.s, self.v)[2], math.inf
        for rate, force, inverse in zip(rates, total, self.field.inverse, strict=True):
            if rate:
                left = abs(force) * inverse / rate
                part = min(REACH, (120.0 * FADING / left) ** 0.2) if left else REACH
                least = min(least, part / rate)
        return least

    def _rates(self, t: float) -> list[float]:
        """1/s. How fast each velocity fades: by the world, the air, dampers of springs."""
        field = self.field
        held = list(self.own.resistance)
        if field.loaded:
            for k, forces in enumerate(field.body_forces(t)):
                for one in forces:
                    held[k] += one.linear + 2.0 * one.quadratic * abs(self.v[k])
        for pair in field.pairs:
            damping = math.fsum(link.damping() for link in pair.links)
            for side in (pair.left, pair.right):
                if side is not None and damping:
                    held[side] += 2.0 * damping  # the other one may come just as fast
        return [each * inverse for each, inverse in zip(held, field.inverse, strict=True)]

    def _pressed(self) -> list[int]:
        modes = self.field.modes or {}
        linked = {pair.gap for pair in self.field.pairs if pair.links}
        return [gap for gap, mode in modes.items() if mode != "apart" or gap in linked]

    def _swing(self, gap: int) -> float:
        pair = self.field.pair_at[gap]
        d, _ = self.field.overlap(pair, self.s, self.v)
        law = contact_law(pair.contact)
        steep = law.steepest if law is not None else 0.0
        steep += sum(link.bounds(max(-d, link.nearest))[0] for link in pair.links)
        return SWING / math.sqrt(2.0 * steep / pair.mu) if steep > 0.0 else math.inf

    def _accept(self, t: float, h: float, s: PerCart, v: PerCart) -> None:
        if not all(map(math.isfinite, (*s, *v))):
            raise self.lost(t)
        super()._accept(t, h, s, v)
        if self.world.delay:
            self.now = t + h
            self.own.remember(self.now, s, v)

    def settle(self, t: float) -> None:
        """Then also: who pushes whom from now on, and when the jump of a push comes back."""
        super().settle(t)
        self.own.meet(t, self.s, self.v)
        if self.world.delay:
            self.late += self.own.remember(self.now, self.s, self.v)

    def stops(self) -> list[float]:
        """Also where a push comes back that has jumped."""
        return [*self.times, *self.late]


class WorldRecorder(SidedRecorder):
    """Of a world, under its name."""

    def __init__(self, scene: Scene, run: WorldStepper) -> None:
        self.own = run.own
        gaps = (pair.gap for pair in run.field.pairs)
        choice = MethodChoice("rk4-events")
        super().__init__(scene, choice, run, scene.until / PARTS, run.own.name, gaps)

    def pushes(self, detail: Detail) -> Mapping[Side, float]:
        """What the world gave to each side."""
        return self.own.on


def follow(scene: Scene, world: World) -> WorldRun:
    """The run of a scene in a world; raises UnsolvedError where it does not come to its end."""
    acts = at_work(world)
    changed = acts.scene(scene)
    stepper = WorldStepper(changed, world.kind.name, acts)
    recorder = WorldRecorder(changed, stepper)
    stepper.drive(changed.until)
    done = recorder.finish()
    columns = done.samples.columns | recorder.columns_on()
    return WorldRun(scene, world, done.run, Trajectory(columns))
