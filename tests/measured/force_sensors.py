"""Two force sensors that push each other, and what may be wrong with them."""

from __future__ import annotations

from random import Random

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import trajectory
from sim.measured.track import Track
from sim.measured.tracks import Measured
from tests.measured.makers import truth

NOISE = 0.05  # N


def sensors(
    *,
    factor: float = 1.0,
    zeros: tuple[float, float] = (0.0, 0.0),
    push_is_positive: bool = False,
    late: float = 0.0,
    noise: float = NOISE,
    seed: int = 1,
) -> Measured:
    """The simulator's contact force as two sensors read it, 1000 times a second."""
    made, random = truth(mass=0.5, ratio=3.0, contact=0.15), Random(seed)
    columns = trajectory(run(made.scene), 64).columns
    times, force = columns[("t",)], columns[("F", "A-B")]

    def at(t: float) -> float:
        for k in range(len(times) - 1):
            if times[k] <= t < times[k + 1]:
                share = (t - times[k]) / (times[k + 1] - times[k])
                return force[k] + share * (force[k + 1] - force[k])
        return 0.0

    grid = tuple(0.3 + k / 1000 for k in range(500))
    sign = 1.0 if push_is_positive else -1.0
    a = tuple(sign * at(t) + zeros[0] + random.gauss(0, noise) for t in grid)
    b = tuple(factor * at(t - late) + zeros[1] + random.gauss(0, noise) for t in grid)
    lines = tuple(range(2, 502))
    return Measured("force", (Track("A", grid, a, lines), Track("B", grid, b, lines)), ())
