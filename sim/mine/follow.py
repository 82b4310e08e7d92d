"""A scene with laws that somebody wrote, followed to its end and recorded.

The accounts say what the law itself does not: what a contact has not given back by the end counts
as warmed, and below nought it is energy that the law has made. What came from nowhere, because two
sides were answered differently, stands under `field.OWN`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sim.dynamics.result.finished import Run
from sim.dynamics.result.trajectory import Trajectory
from sim.dynamics.stepping.methods import MethodChoice
from sim.dynamics.stepping.pairs import Detail
from sim.dynamics.stepping.sided import Side, SidedRecorder
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


class WrittenRecorder(SidedRecorder):
    """Of laws that somebody wrote, under `field.OWN`."""

    def __init__(self, scene: Scene, run: EmbeddedStepper) -> None:
        self.own = run.own
        gaps = (pair.gap for pair, _ in run.own.written)
        super().__init__(scene, MethodChoice(METHOD, rtol=run.rtol), run, run.longest, OWN, gaps)

    def pushes(self, detail: Detail) -> Mapping[Side, float]:
        """What the law answered to each side."""
        found = {}
        for pair, force in self.own.written:
            push = detail.push[pair.gap]
            found[pair.gap, 0], found[pair.gap, 1] = push + force.odd, push - force.odd
        return found


def follow(scene: Scene, rtol: float = RTOL) -> WrittenRun:
    """The run; raises `WrongLawError` for a law that gives no force, UnsolvedError where no steps
    lead to the end."""
    stepper = EmbeddedStepper(scene, rtol)
    recorder = WrittenRecorder(scene, stepper)
    stepper.drive(scene.until)
    done = recorder.finish()
    columns, unequal = done.samples.columns, stepper.own.unequal
    if unequal:
        columns = columns | recorder.columns_on()
    else:  # nothing came from nowhere, and nothing is told of it
        columns = {key: column for key, column in columns.items() if key[:2] != ("E", OWN)}
    return WrittenRun(scene, done.run, Trajectory(columns), stepper.own.calls, unequal)
