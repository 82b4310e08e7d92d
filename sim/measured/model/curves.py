"""The model at many times at once, for fitting: flights by numpy, contacts by their closed form.

A contact holds few frames of a film; what lies outside is two parabolas for each cart.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from sim.measured.model.motion import Motion, State, pull

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]


def places(
    motion: Motion, cart: int, t: Floats, states: dict[float, State] | None = None
) -> Floats:
    """m. Places of a cart at the times t [s]. `states`: of both carts within the contact, to be
    handed on to the other cart, which mostly has the same times."""
    import numpy as np

    p = motion.parameters
    tau = t - p.touch
    before, after = tau <= 0.0, tau >= motion.duration
    x = np.empty_like(tau)
    start = p.x + (p.distance if cart else 0.0)
    first = 0.0 if p.rests[cart] else p.v[cart]
    x[before] = _flown(start, first, tau[before], p.friction[cart], p.tilt)
    (ends, speeds), gone = motion.after, tau[after] - motion.duration
    x[after] = _flown(ends[cart], speeds[cart], gone, p.friction[cart], p.tilt)
    inside = np.flatnonzero(~before & ~after)
    if inside.size:
        known = {} if states is None else states
        times = t[inside].tolist()
        for time in times:
            if time not in known:
                known[time] = motion.state(time)
        x[inside] = [known[time][0][cart] for time in times]
    return x


def _flown(x: float, v: float, tau: Any, friction: float, tilt: float) -> Any:
    import numpy as np

    a, stands = pull(v, friction, tilt)
    tau = np.minimum(tau, stands) if stands >= 0.0 else np.maximum(tau, stands)
    return x + (v + 0.5 * a * tau) * tau
