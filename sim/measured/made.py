"""Readings with a known truth: a scene is run, its carts are filmed, and noise is added.

The run is the simulator's own (sim.dynamics), not the model that is fitted.
"""

from __future__ import annotations

from collections.abc import Sequence
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


def tracker_text(names: Sequence[str], times: Sequence[float],
                 places: Sequence[Sequence[float]]) -> str:  # fmt: skip
    """Both carts as Tracker exports several tracks, tab between columns; `places` by cart, m."""
    lines = ["#multi:", "\t" + "".join(f"{name.replace(' ', '_')}\t\t" for name in names)]
    lines.append("t\t" + "x\ty\t" * len(names))
    for k, t in enumerate(times):
        cells = [_scientific(t)]
        for track in places:
            cells += [_scientific(track[k]), _scientific(0.0)]
        lines.append("\t".join(cells) + "\t")
    return "\n".join(lines) + "\n"


def _scientific(value: float) -> str:
    """3.200000000E-2, as Tracker writes it."""
    mantissa, exponent = f"{value:.9E}".split("E")
    return f"{mantissa}E{int(exponent)}"
