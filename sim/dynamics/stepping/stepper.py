"""Steps of any method through one scene: trial steps, events where they are located, impacts.

A `Stepper` holds the state of one run. `seen` is told of every accepted step, or part of one that
an event ended, so that a run can be recorded; without it nothing is kept.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sim.dynamics.stepping.falls import Along, first_falls
from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.impacts import Impacts
from sim.dynamics.stepping.located import MOST_CHANGES, Key, Located
from sim.dynamics.stepping.method import StepMethod
from sim.dynamics.stepping.pairs import Detail, PerCart
from sim.dynamics.stepping.rk4 import RK4
from sim.laws.rounding import LAST_BITS
from sim.scene.model import Scene

Seen = Callable[[float, float, list[tuple[float, Detail]]], None]
"""t [s] at the end, h [s], and the forces with their weights."""


class Stepper:
    """Fixed steps without any look at events."""

    def __init__(self, scene: Scene, method: type[StepMethod], lanes: int = 0) -> None:
        self.field = self.make_field(scene, lanes)
        self.method = method
        zero = self.field.number()
        self.s: PerCart = [zero for _ in scene.carts]
        self.v: PerCart = [zero + cart.velocity for cart in scene.carts]
        self.impacts = Impacts(self.field)
        self.impacts.latch(self.s, self.v)
        self.impacts.settle(-1.0, self.s, self.v)
        self.seen: Seen | None = None
        self.steps = 0

    def make_field(self, scene: Scene, lanes: int) -> Field:
        """The forces that it steps through."""
        return Field(scene, lanes)

    def watch(self, seen: Seen) -> None:
        """From now on tell of every step."""
        self.seen = seen
        self.field.keep = []

    def start(self) -> None:
        """Exploders that act at t = 0: carts that touch then may have parted a step later."""
        if any(one.time <= 0.0 for one in self.impacts.releases):
            self.impacts.settle(0.0, self.s, self.v)
            self.tell_blows(0.0)

    def tell_blows(self, t: float) -> None:
        """Blows fall after the step that ends with them was told: a step of no length tells."""
        if self.seen is not None and self.impacts.blows:
            self.seen(t, 0.0, [])

    def advance(self, t: Any, h: Any) -> None:
        """From t over h."""
        self.steps += 1
        self.s, self.v = self.method.step(self.field, t, self.s, self.v, h)
        self.impacts.settle(t + h, self.s, self.v)
        if self.seen is not None:
            self.tell(t + h, h, self.method.weights)

    def tell(self, t: float, h: float, weights: tuple[float, ...]) -> None:
        """Hand over the forces of the last evaluations."""
        assert self.seen is not None and self.field.keep is not None
        kept = self.field.keep[-len(weights) :]
        self.field.keep.clear()
        self.seen(t, h, list(zip(weights, kept, strict=True)))

    def boundaries(self, t: float, end: float) -> list[float]:
        """Times between t and end at which a step has to end; without a look there are none."""
        return [end]


class LocatedStepper(Stepper):
    """Fixed steps of RK4 that end at every event, at every switch and at every exploder."""

    most_changes = MOST_CHANGES

    def __init__(self, scene: Scene, method: type[StepMethod] = RK4) -> None:
        super().__init__(scene, method)
        self.located = Located(self.field, self.impacts, self.s, self.v)
        times = {*self.field.switches, *(one.time for one in self.field.releases)}
        self.times = sorted(t for t in times if t > 0.0)

    def start(self) -> None:
        """No step may begin before exploders that act at t = 0 have."""
        self.settle(0.0)

    def settle(self, t: float) -> None:
        """At the end of a step: exploders act, and formulas change where they or a switch do."""
        near = (time for time in self.times if abs(time - t) <= LAST_BITS * t)
        t = next(near, t)  # t + (stop − t) may be a bit before the stop
        left = len(self.impacts.releases)
        self.impacts.settle(t, self.s, self.v)
        if left != len(self.impacts.releases) or t in self.times:
            self.located.begin(t, self.s, self.v)
        self.tell_blows(t)

    def boundaries(self, t: float, end: float) -> list[float]:
        """Switches and exploders on the way."""
        return [*(time for time in self.times if t < time < end), end]

    def advance(self, t: float, h: float) -> None:
        """From t over h, part by part."""
        self.steps += 1
        field, done = self.field, 0.0
        field.force_time = t + 0.5 * h
        for _ in range(self.most_changes):
            part, keys = self.part(t + done, h - done)
            done += part
            if keys:
                self.located.change(keys, t + done, self.s, self.v)
                self.tell_blows(t + done)
            if not keys or done >= h:
                break
        else:
            self.give_up(t + done, h - done)
        field.force_time = None
        self.settle(t + h)

    def give_up(self, t: float, h: float) -> None:
        """Too many events within one step: the rest of it without looking."""
        self.field.modes = None
        Stepper.advance(self, t, h)
        self.located.begin(t + h, self.s, self.v)

    def part(self, t: float, h: float) -> tuple[float, list[Key]]:
        """Take h, or less up to the first event; returns how much, and the guards that fell."""
        s, v = self.s, self.v
        s1, v1 = self.method.step(self.field, t, s, v, h)
        first, keys = first_falls(self.located, t, h, (s, v), (s1, v1), self._along(t))
        if first > 0.0:
            if keys:
                s1, v1 = self.method.step(self.field, t, s, v, first)
            self._accept(t, first, s1, v1)
        return first, keys

    def _along(self, t: float) -> Along:
        """Ways and velocities in a step from now, by trial steps."""
        return lambda tau: self.method.step(self.field, t, self.s, self.v, tau)

    def _accept(self, t: float, h: float, s: PerCart, v: PerCart) -> None:
        self.s, self.v = s, v
        if self.seen is not None:
            self.tell(t + h, h, self.method.weights)
