"""Readings with a known truth: a scene is run, its carts are filmed, and noise is added.

The run is the simulator's own (sim.dynamics), not the model that is fitted.
"""

from __future__ import annotations

from random import Random

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.measured.track import Track
from sim.measured.tracks import Measured
from sim.scene import Scene


def filmed(scene: Scene, *, rate: float, noise: float, seed: int, begin: float = 0.0) -> Measured:
    """Readings of the two carts of `scene`: `rate` frames per s, `noise` m (standard deviation).

    `begin`: the clock of the film when the scene starts, in s.
    """
    random = Random(seed)
    finished = run(scene)
    frames = range(int(scene.until * rate + 1e-9) + 1)
    places = [sample(finished, min(k / rate, scene.until))[0] for k in frames]
    times = tuple(begin + k / rate for k in frames)
    tracks = [
        Track(
            cart.name,
            times,
            tuple(row[index] + random.gauss(0.0, noise) for row in places),
            tuple(range(4, 4 + len(times))),
        )
        for index, cart in enumerate(scene.carts)
    ]
    return Measured("length", (tracks[0], tracks[1]), ())
