"""Contact forces written down a second time, straight from their definitions, to be integrated.

Nothing here is shared with `sim.dynamics`: no half angles, no closed forms. scipy's DOP853 at
1e-12 with located events is the independent oracle.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp


@dataclass(frozen=True)
class Outcome:
    """What one contact of a pair comes to."""

    duration: float
    separation_speed: float
    overlap_left: float
    greatest_force: float
    impulse: float


def zeta_printed(e: float) -> float:
    """Damping ratio of the paper's equation (3)."""
    return -math.log(e) / math.sqrt(math.pi**2 + math.log(e) ** 2)


def zeta_for_zero_force(e: float) -> float:
    """Damping ratio with exp(−2 zeta arccos(zeta)/sqrt(1−zeta²)) = e, found by bisection."""

    def delivered(zeta: float) -> float:
        if zeta < 1:
            return math.exp(-2 * zeta * math.acos(zeta) / math.sqrt(1 - zeta**2))
        return (
            math.exp(-2 * zeta * math.acosh(zeta) / math.sqrt(zeta**2 - 1))
            if zeta > 1
            else math.exp(-2)
        )

    low, high = 0.0, 1e4
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if delivered(middle) > e else (low, middle)
    return 0.5 * (low + high)


def integrate(law: str, e: float, k: float, mu: float, u: float) -> Outcome:
    """One contact from first touch, by integration of mu d'' = −N."""
    if law == "bumper":
        return _bumper(e, k, mu, u)
    zeta = zeta_for_zero_force(e) if law == "push-only" else zeta_printed(e)
    c = 2 * zeta * math.sqrt(k * mu)

    def force(d: float, v: float) -> float:
        return k * d + c * v

    def over(t: float, y: np.ndarray) -> float:
        if law == "paper":
            return float(y[0]) if t > 0 else 1.0
        return force(y[0], y[1])

    over.terminal, over.direction = True, -1  # type: ignore[attr-defined]
    return _solve(force, over, [0.0, u], mu, math.sqrt(k / mu))


def _bumper(e: float, k: float, mu: float, u: float) -> Outcome:
    def turned(t: float, y: np.ndarray) -> float:
        return float(y[1])

    turned.terminal = True  # type: ignore[attr-defined]
    first = _solve(lambda d, v: k * d, turned, [0.0, u], mu, math.sqrt(k / mu))
    deepest = first.overlap_left

    def force(d: float, v: float) -> float:
        return k / e**2 * (d - (1 - e**2) * deepest)

    def gone(t: float, y: np.ndarray) -> float:
        return force(y[0], y[1])

    gone.terminal = True  # type: ignore[attr-defined]
    second = _solve(force, gone, [deepest, 0.0], mu, math.sqrt(k / mu) / e)
    return Outcome(
        first.duration + second.duration,
        second.separation_speed,
        second.overlap_left,
        first.greatest_force,
        first.impulse + second.impulse,
    )


def _solve(force, stop, start: list[float], mu: float, w: float) -> Outcome:
    result = solve_ivp(
        lambda t, y: [y[1], -force(y[0], y[1]) / mu, force(y[0], y[1])],
        (0.0, 50.0 / w),
        [*start, 0.0],
        method="DOP853",
        rtol=1e-12,
        atol=1e-14,
        events=stop,
        dense_output=True,
        max_step=0.05 / w,
    )
    t = result.t_events[0][0]
    d, v, impulse = result.y_events[0][0]
    grid = result.sol(np.linspace(0.0, t, 4001))
    return Outcome(
        t, -v, d, max(force(a, b) for a, b in zip(grid[0], grid[1], strict=True)), impulse
    )
