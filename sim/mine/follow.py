"""A scene with laws that somebody wrote, followed to its end and recorded.

The accounts say what the law itself does not: what a contact has not given back by the end counts
as warmed, and below nought it is energy that the law has made. What came from nowhere, because two
sides were answered differently, stands under `field.OWN`.
"""

from __future__ import annotations

from array import array
from dataclasses import dataclass

from sim.dynamics.result.finished import Run
from sim.dynamics.result.trajectory import Trajectory
from sim.dynamics.stepping.methods import Way
from sim.dynamics.stepping.pairs import Detail, Row
from sim.dynamics.stepping.recorded import Recorder
from sim.mine.embedded import RTOL, EmbeddedStepper
from sim.mine.field import OWN
from sim.scene.model import Scene

METHOD = "rk45-events"
"""What the plan calls it."""


@dataclass(frozen=True, slots=True)
class WrittenRun:
    """The run, its samples, and how often the laws were asked. `unequal`: by two sides."""

    scene: Scene
    run: Run
    samples: Trajectory
    calls: int
    unequal: bool


class WrittenRecorder(Recorder):
    """Keeps what came from nowhere, and the push on each side of every gap."""

    def __init__(self, scene: Scene, run: EmbeddedStepper) -> None:
        self.own = run.own
        self.on: dict[tuple[int, int], array[float]] = {
            (pair.gap, side): array("d") for pair, _ in run.own.written for side in (0, 1)
        }
        super().__init__(scene, Way(METHOD, rtol=run.rtol), run, run.longest)

    def from_outside(self) -> list[tuple[str, int]]:
        """The laws beside the scene's own effects."""
        return [*super().from_outside(), *((OWN, k) for k in range(self.own.count))]

    def _row(self, t: float, a: Row, detail: Detail) -> None:
        super()._row(t, a, detail)  # the forces were evaluated for this very instant
        for pair, force in self.own.written:
            push = detail.push[pair.gap]
            self.on[pair.gap, 0].append(push + force.odd)
            self.on[pair.gap, 1].append(push - force.odd)


def follow(scene: Scene, rtol: float = RTOL) -> WrittenRun:
    """The run; raises `WrongLawError` for a law that gives no force, UnsolvedError where no steps
    lead to the end."""
    stepper = EmbeddedStepper(scene, rtol)
    recorder = WrittenRecorder(scene, stepper)
    stepper.drive(scene.until)
    done = recorder.finish()
    columns, unequal = dict(done.samples.columns), stepper.own.unequal
    for (gap, side), column in recorder.on.items():
        names = scene.names_at(gap)
        if unequal:
            columns["on", "-".join(names), names[side]] = column
    if not unequal:  # nothing came from nowhere, and nothing is told of it
        columns = {key: column for key, column in columns.items() if key[:2] != ("E", OWN)}
    return WrittenRun(scene, done.run, Trajectory(columns), stepper.own.calls, unequal)
