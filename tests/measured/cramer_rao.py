"""How well numbers can be known from a film at best, by the simulator alone."""

from __future__ import annotations

import math

import numpy as np

from sim.dynamics.loop.run import run
from sim.dynamics.result.trajectory import sample
from sim.scene import read_scene
from tests.measured.makers import NOISE, Truth


def simulated(made: Truth, change: dict[str, float], rate: float) -> np.ndarray:
    """Places in a film of the scene with other numbers: an oracle that knows nothing of the fit."""
    e, ratio = made.e + change.get("e", 0.0), made.ratio * math.exp(change.get("ln_ratio", 0.0))
    w0 = made.w0 * math.exp(change.get("ln_w0", 0.0))
    v = (made.v[0] + change.get("v1", 0.0), made.v[1] + change.get("v2", 0.0))
    first, _second = made.scene.carts
    # The touch stays where it is: carts start where they must.
    x1 = first.position + made.v[0] * made.touch + change.get("x", 0.0)
    length = first.length + change.get("distance", 0.0)
    plain = {
        "carts": {
            "A": {"mass": 1, "position": x1 - v[0] * made.touch, "velocity": v[0],
                  "length": length},
            "B": {"mass": ratio, "position": x1 + length - v[1] * made.touch, "velocity": v[1],
                  "length": length},
        },
        "contact": {"restitution": e, "stiffness": ratio / (1 + ratio) * w0**2},
        "until": made.scene.until + 0.1,
    }  # fmt: skip
    finished = run(read_scene(plain))
    begin = 0.02 - change.get("touch", 0.0)  # no time may lie before the start of the run
    times = [begin + k / rate for k in range(int(made.scene.until * rate) + 1)]
    return np.array([sample(finished, t)[0] for t in times]).T.ravel()


def bound(made: Truth, rate: float) -> dict[str, float]:
    """Cramér–Rao: no unbiased estimate has a smaller standard deviation. By the simulator alone."""
    names = ("touch", "x", "ln_ratio", "e", "ln_w0", "distance", "v1", "v2")
    step = 1e-5
    columns = [
        (simulated(made, {n: step}, rate) - simulated(made, {n: -step}, rate)) / (2 * step)
        for n in names
    ]
    jacobian = np.column_stack(columns) / NOISE
    return dict(zip(names, np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian))), strict=True))
