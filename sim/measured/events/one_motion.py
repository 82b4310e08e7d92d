"""Whether both columns hold one motion: the same mark twice, or two marks of one cart.

Then x_B − x_A stays the same, whatever the cart does, and no bounce is to be found in it. Two
sensors that face each other and carts that move alike look the same: whoever knows that turns one.
"""

from __future__ import annotations

from sim.measured.refusal import FitError
from sim.measured.tracks import Measured
from sim.scene.said import said

SAME = 0.01
"""Root mean square of what the distance changes, of how far the carts go: marks of one cart keep it
to 2 mm in 0.5 m; two that come at each other with speeds that differ by 5 % are beyond it."""


def check_two_motions(measured: Measured) -> None:
    """Raises FitError where there is only one."""
    import numpy as np

    a, b = measured.tracks
    t = np.asarray(a.t)
    kept = (t >= b.t[0]) & (t <= b.t[-1])
    if not kept.any():
        return
    x = np.asarray(a.value)[kept]
    apart = np.interp(t[kept], b.t, b.value) - x
    if float(np.std(apart)) > SAME * float(np.ptp(x)):
        return
    raise FitError(
        said("both columns show one motion: are these two carts?"),
        said("mark one cart in each; of two sensors that face each other turn one"),
        "one-motion",
    )
