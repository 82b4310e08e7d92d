"""Runs in which a push may be no pair: a world that does not exist, a law that somebody wrote.

Steps are as long as the stepper itself wants the next one, each up to the first event. What acts on
single carts and comes from nowhere is booked under one name, and the push on each side of a gap is
kept for itself, as columns ("on", pair, body) [N], positive where it pushes the two apart.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Mapping

from sim.dynamics.result.outcome import UnsolvedError
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.pairs import Detail, PerCart
from sim.dynamics.stepping.recorded import Recorder
from sim.dynamics.stepping.stepper import LocatedStepper
from sim.scene.model import Scene

STUCK = 40
"""Events at one instant, one after the other, without a step between them."""

Side = tuple[int, int]
"""A gap, and its left (0) or right (1) side."""


class OwnSteps(LocatedStepper):
    """Steps of its own length to the end of a scene."""

    def length(self, t: float) -> float:
        """s. The next step, at most."""
        raise NotImplementedError

    def stops(self) -> Iterable[float]:
        """Instants in s at which a step has to end, whatever happens."""
        return self.times

    def changed(self) -> None:
        """An event has ended a step."""

    def spent(self) -> bool:
        """Is it more than a run may take?"""
        raise NotImplementedError

    def lost(self, t: float) -> UnsolvedError:
        """Why the steps do not come to the end."""
        raise NotImplementedError

    def drive(self, until: float) -> None:
        """To the end of the scene; raises UnsolvedError where the steps do not come to it."""
        t, still = 0.0, 0
        self.start()
        while t < until:
            stop = min([until, *(time for time in self.stops() if time > t)])
            end = min(stop, t + self.length(t))
            self.field.force_time = 0.5 * (t + end)
            done, keys = self.part(t, end - t)
            self.steps += 1
            if keys:
                self.located.change(keys, t + done, self.s, self.v)
                self.tell_blows(t + done)
                self.changed()
            t = end if done == end - t else t + done
            self.field.force_time = None
            still = still + 1 if done == 0.0 else 0
            self.settle(t)
            if still > STUCK or self.spent():
                raise self.lost(t)


class SidedRecorder(Recorder):
    """Keeps what came from nowhere under `name`, and the push on each side of `gaps`."""

    def __init__(
        self, scene: Scene, choice: MethodChoice, run: LocatedStepper, step: float, name: str,
        gaps: Iterable[int],
    ) -> None:  # fmt: skip
        self.name = name
        self.on: dict[Side, array[float]] = {
            (gap, side): array("d") for gap in gaps for side in (0, 1)
        }
        super().__init__(scene, choice, run, step)

    def from_outside(self) -> list[tuple[str, int]]:
        """What comes from nowhere, beside the scene's own effects."""
        return [*super().from_outside(), *((self.name, k) for k in range(self.run.field.count))]

    def pushes(self, detail: Detail) -> Mapping[Side, float]:
        """N on each side, at the instant for which the forces were evaluated last."""
        raise NotImplementedError

    def columns_on(self) -> dict[tuple[str, ...], array[float]]:
        """The pushes, by pair and body."""
        found: dict[tuple[str, ...], array[float]] = {}
        for (gap, side), column in self.on.items():
            names = self.scene.names_at(gap)
            found["on", "-".join(names), names[side]] = column
        return found

    def _row(self, t: float, a: PerCart, detail: Detail) -> None:
        super()._row(t, a, detail)
        pushes = self.pushes(detail)
        for key, column in self.on.items():
            column.append(pushes.get(key, 0.0))
