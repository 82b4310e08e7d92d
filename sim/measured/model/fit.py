"""Least squares of the model on readings of two carts, with intervals.

Fitted are touch, x, distance, v of both, ln(mass ratio), e, ln(w0), and on request a constant
deceleration for each cart, a tilt or both. Logarithms keep ratio and w0 positive and make their
intervals honest. Every reading counts alike. Of white noise the covariance would be

    s² (JᵀJ)⁻¹ ,   s² = sum of squares / (readings − unknowns) ,   with Student's t;

`coloured` weighs by the residuals how far the noise is from white, and widens it by as much.
A singular value of J near zero means that the readings do not tell one unknown: its variance
becomes infinite, and `known` refuses to print it. numpy and scipy are imported inside.

Readings farther off than WILD standard deviations (told robustly: 1.48 times the median of |r|) are
no chance of a normal noise, and their squares would move everything. Where there are such, the fit
is done again with Huber's loss, which counts them by their distance beyond that limit; in noise and
covariance they stand at the limit. Without any, nothing of this is done.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from sim.measured.model.bounds import bounds_of
from sim.measured.model.contact import Law
from sim.measured.model.covariance import covariance_of
from sim.measured.model.curves import places
from sim.measured.model.guess import EACH_SIDE, check_sides, guesses
from sim.measured.model.motion import Motion, Parameters, State
from sim.measured.model.standing import sizes_of
from sim.measured.model.unknowns import READ, RUBS, Effect, names_of, with_values
from sim.measured.refusal import FitError
from sim.measured.rounding import EVEN, step_of
from sim.measured.scatter import scatter_of
from sim.measured.tracks import Measured
from sim.scene.said import said

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

SHARE = 0.95
CLOSE = 1e-8
"""Relative. A descent ends when its steps, or what they gain, are smaller."""

WILD = 4.0
"""Standard deviations: of 600 normal readings one is farther off in 4 of 100 films."""

ROUNDING = 1e-7
"""Of the greatest distance of two readings: residuals below are rounding, none of them wild."""

STILL = 4.0
"""A cart whose speed before the touch is below so many standard deviations stood still."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """How to fit. `distance`: m, of the marks at the touch, if known; `lasts`: as the start."""

    law: Law = "bumper"
    effect: Effect = "none"
    distance: float | None = None
    lasts: bool = False


@dataclass(frozen=True, slots=True)
class Fit:
    """The best parameters; `covariance` belongs to `unknowns`, whose values are `values`."""

    asked: Asked
    parameters: Parameters
    duration: float  # s
    unknowns: tuple[str, ...]
    values: tuple[float, ...]
    covariance: tuple[tuple[float, ...], ...]
    residuals: tuple[tuple[float, ...], tuple[float, ...]]  # m, measured minus model
    noise: float  # m, standard deviation of a reading
    freedom: int
    squares: float  # m²
    heavy: int = 0  # readings that count less than the others

    def sd(self, unknown: str) -> float:
        """Standard deviation of one unknown; inf where the readings do not tell it."""
        k = self.unknowns.index(unknown)
        return math.sqrt(self.covariance[k][k])

    def spread(self, slopes: dict[str, float]) -> float:
        """Standard deviation of a quantity with these derivatives by the unknowns."""
        rows = [(self.unknowns.index(name), slope) for name, slope in slopes.items()]
        total = sum(a * b * self.covariance[i][k] for i, a in rows for k, b in rows)
        return math.sqrt(max(total, 0.0))

    @property
    def factor(self) -> float:
        """Half an interval in standard deviations."""
        from scipy.special import stdtrit

        return float(stdtrit(self.freedom, 0.5 * (1.0 + SHARE)))


def warm_up() -> bool:
    """Imports what a fit needs; whether it works."""
    from scipy.optimize import least_squares
    from scipy.special import stdtrit

    return callable(least_squares) and float(stdtrit(9, 0.975)) > 2.0


def fit(measured: Measured, asked: Asked = Asked(), start: Parameters | None = None) -> Fit:
    """The best fit; raises FitError. `start`: a first guess, in the place of our own."""
    import numpy as np

    t = tuple(np.array(track.t) for track in measured.tracks)
    x = tuple(np.array(track.value) for track in measured.tracks)
    times, values = (t[0], t[1]), (x[0], x[1])

    def score(parameters: Parameters) -> float:
        return float(np.sum(_residuals(parameters, asked.law, times, values) ** 2))

    tried = [start] if start else guesses(times, values, asked.law, asked.distance, score)
    if asked.effect in RUBS:
        tried = [_with_rest(one, times, values) for one in tried]
    solved = [_solve(one, asked, times, values) for one in tried]
    best = min(solved, key=lambda one: one[0])
    steps = [step_of(one) for one in values]
    limit = _limit(best[1], asked, times, values, steps)
    for _ in range(2 if math.isfinite(limit) else 0):
        best = _solve(best[1], asked, times, values, limit)
        limit = _limit(best[1], asked, times, values, steps)
    return _made(best[1], best[2], asked, times, values, steps, limit)


def _limit(p: Parameters, asked: Asked, t: Any, x: Any, steps: list[float]) -> float:
    """m. Where readings begin to count less; infinite where none does."""
    import numpy as np

    off = np.abs(_residuals(p, asked.law, t, x))
    reach = float(np.ptp(np.concatenate(x)))
    usual = max(scatter_of(off), EVEN * max(steps))
    limit = max(WILD * usual, ROUNDING * reach)
    return limit if float(off.max()) > limit else math.inf


def _with_rest(p: Parameters, t: Any, x: Any) -> Parameters:
    """Notes which carts stand still before the touch: friction does not push them."""
    import numpy as np

    rests = []
    for k in range(2):
        before = t[k] < p.touch
        if int(np.sum(before)) < EACH_SIDE:
            rests.append(False)
            continue
        tau, places_ = t[k][before] - t[k][before].mean(), x[k][before]
        slope = float(tau @ places_ / (tau @ tau))
        left = places_ - places_.mean() - slope * tau
        sd = math.sqrt(float(left @ left) / max(1, len(left) - 2) / float(tau @ tau))
        rests.append(abs(slope) < max(STILL * sd, 0.01 * p.approach))
    v = (0.0 if rests[0] else p.v[0], 0.0 if rests[1] else p.v[1])
    return replace(p, rests=(rests[0], rests[1]), v=v)


def _residuals(p: Parameters, law: Law, t: Any, x: Any) -> Floats:
    """m. Measured minus model, cart after cart."""
    import numpy as np

    motion, states = Motion(p, law), dict[float, State]()
    return np.concatenate([x[k] - places(motion, k, t[k], states) for k in range(2)])


def _solve(
    start: Parameters, asked: Asked, t: Any, x: Any, limit: float = math.inf
) -> tuple[float, Parameters, Any]:
    """Sum of squares, parameters and Jacobian (by the unknowns) of one descent; Huber's loss beyond
    `limit` in m."""
    import numpy as np
    from scipy.optimize import least_squares

    names = names_of(start, asked.effect, asked.distance, lasts=asked.lasts)
    low, high = bounds_of(names, t, x)
    begin = np.clip([READ[name](start) for name in names], low + 1e-9 * (high - low),
                    high - 1e-9 * (high - low))  # fmt: skip

    def residuals(values: Floats) -> Floats:
        # listed: a numpy number in the closed form costs three times a float
        return _residuals(with_values(start, names, values.tolist()), asked.law, t, x)

    found = least_squares(
        residuals, begin, bounds=(low, high), x_scale="jac", method="trf",
        xtol=CLOSE, ftol=CLOSE, gtol=1e-12, max_nfev=80,
        **({"loss": "huber", "f_scale": limit} if math.isfinite(limit) else {}),
    )  # fmt: skip
    return 2.0 * float(found.cost), with_values(start, names, found.x.tolist()), found.jac


def _made(
    p: Parameters, jacobian: Any, asked: Asked, t: Any, x: Any, steps: list[float], limit: float
) -> Fit:
    import numpy as np

    names = names_of(p, asked.effect, asked.distance, lasts=asked.lasts)
    residuals = _residuals(p, asked.law, t, x)
    freedom = len(residuals) - len(names)
    if freedom < 3:
        reason = said("there are hardly more readings than unknowns")
        raise FitError(reason, said("mark more frames"))
    motion = Motion(p, asked.law)
    sides = [(int(np.sum(times < p.touch)), int(np.sum(times > p.touch + motion.duration)))
             for times in t]  # fmt: skip
    check_sides(sides)
    counted = np.clip(residuals, -limit, limit)
    squares = float(counted @ counted)
    noise = math.sqrt(squares / freedom)
    first = len(t[0])
    both = counted[:first], counted[first:]
    return Fit(
        asked=asked,
        parameters=p,
        duration=motion.duration,
        unknowns=names,
        values=tuple(READ[name](p) for name in names),
        covariance=covariance_of(
            jacobian,
            both,
            freedom,
            np.concatenate([_pushed(times, p.touch, motion.duration) for times in t]),
            np.concatenate(sizes_of(both, t, p)),
            steps,
        ),
        residuals=(tuple(residuals[:first].tolist()), tuple(residuals[first:].tolist())),
        noise=noise,
        freedom=freedom,
        squares=squares,
        heavy=int(np.sum(np.abs(residuals) > limit)),
    )


def _pushed(t: Floats, touch: float, duration: float) -> Any:
    """Which readings lie in the contact, or beside it by no more than a frame."""
    import numpy as np

    frame = float(np.median(np.diff(t)))
    return (t > touch - frame) & (t < touch + duration + frame)
