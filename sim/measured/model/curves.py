"""The model at many times at once, for fitting: flights by numpy, contacts by their closed form.

A contact holds few frames of a film; what lies outside is two parabolas for each cart.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from sim.measured.model.motion import Motion

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


def places(motion: Motion, cart: int, t: Floats) -> Floats:
    """m. Places of a cart at the times t [s]."""
    import numpy as np

    p = motion.parameters
    tau = t - p.touch
    before, after = tau <= 0.0, tau >= motion.duration
    x = np.empty_like(tau)
    start = p.x + (p.distance if cart else 0.0)
    first = 0.0 if p.rests[cart] else p.v[cart]
    x[before] = _braked(start, first, tau[before], p.friction[cart])
    (ends, speeds), gone = motion.after, tau[after] - motion.duration
    x[after] = _braked(ends[cart], speeds[cart], gone, p.friction[cart])
    inside = np.flatnonzero(~before & ~after)
    if inside.size:
        tilt = 0.5 * p.tilt
        x[inside] = [motion.state(float(t[k]))[0][cart] - tilt * float(tau[k]) ** 2 for k in inside]
    return x + 0.5 * p.tilt * tau * tau if p.tilt else x


def _braked(x: float, v: float, tau: Any, g: float) -> Any:
    import numpy as np

    if g <= 0.0 or v == 0.0:
        return x + v * tau
    tau = np.minimum(tau, abs(v) / g)
    return x + (v - np.copysign(0.5 * g, v) * tau) * tau
