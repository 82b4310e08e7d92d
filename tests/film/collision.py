"""Films of a collision that the simulator ran: what a page should find in them is known."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from tests.film.maker import Stage, encoded, frames
from tests.measured.makers import Truth

QUICK = {"preset": "ultrafast", "crf": "20"}  # of x264


@dataclass(frozen=True)
class Filmed:
    """A film as bytes, and what is on it: times in s of the file, places of both carts in m."""

    content: bytes
    times: NDArray[np.float64]
    places: tuple[NDArray[np.float64], NDArray[np.float64]]
    stage: Stage

    def clicks(self, frame: int = 0) -> list[tuple[float, float]]:
        """Where the two marks and the two ends of the ruler are, in pixels."""
        marks = [self.stage.place(float(x[frame])) for x in self.places]
        return [*marks, *self.stage.ruler]


def uneven(until: float, rate: float, seed: int = 5) -> NDArray[np.float64]:
    """Times in whole milliseconds, `rate` in the mean: phones let the distance of frames vary."""
    random = np.random.default_rng(seed)
    count = int(until * rate)
    times = np.arange(count) / rate + random.uniform(-0.25, 0.25, count) / rate
    times[0] = 0.0
    rounded: NDArray[np.float64] = np.round(times, 3)
    return rounded


def filmed(made: Truth, stage: Stage, rate: float, **how: object) -> Filmed:
    """The scene of `made` before the camera of `stage`; `how`: codec, kind, options."""
    times = uneven(made.scene.until, rate)
    finished = run(made.scene)
    rows = np.array([sample(finished, float(t))[0] for t in times])
    places = (rows[:, 0], rows[:, 1])
    content = encoded(frames(stage, times, places), times, stage, **how)  # type: ignore[arg-type]
    return Filmed(content, times, places, stage)
