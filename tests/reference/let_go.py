"""Exploders with a spring, integrated: a second opinion that shares no formula with the program.

    m a = sum of  k max(L − r, 0) of springs that were let go and have not fallen off,
                  s max(−r, 0) of bumpers that give back all, or s max(−r, 0)^1.5,
                  F − b v − μ m g sign(v) of each cart                     r: room between two carts

DOP853 of scipy, anew from where a spring has its full length; its error control finds the touches.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

TIGHT = {"rtol": 1e-12, "atol": 1e-14, "method": "DOP853"}
"""The tightest that the method still follows: errors of 1e-11 or so in a run of some steps."""


@dataclass
class Bodies:
    """Carts from left to right; `rooms` [m] between them at the start, the first one to a wall."""

    mass: list[float]
    v: list[float]
    rooms: list[float]  # inf: no wall
    stiff: float  # N/m of bumpers
    force: list[float] = field(default_factory=list)  # N on each
    drag: float = 0.0  # N s/m on each
    rub: float = 0.0  # m/s², μ g
    power: float = 1.0
    springs: list[tuple[int, float, float]] = field(default_factory=list)  # gap, k, E


@dataclass(frozen=True)
class Ended:
    """Ways [m] and velocities [m/s] at the end, and when each spring fell off [s], by gap."""

    way: list[float]
    v: list[float]
    fell: dict[int, float]


def followed(row: Bodies, until: float) -> Ended:
    """All springs are let go at t = 0."""
    n = len(row.mass)
    length = {gap: math.sqrt(2.0 * e / k) for gap, k, e in row.springs}
    stiff = {gap: k for gap, k, _ in row.springs}
    on, fell = set(length), {}

    def rooms(s: Any) -> list[float]:
        ends = [0.0, *s]
        return [row.rooms[g] + ends[g + 1] - ends[g] for g in range(n)]

    def field_of(pushing: frozenset[int]) -> Callable[[float, Any], list[float]]:
        def slope(_t: float, y: Any) -> list[float]:
            s, v = y[:n], y[n:]
            total = [
                (row.force[i] if row.force else 0.0)
                - row.drag * v[i]
                - row.rub * row.mass[i] * float(np.sign(v[i]))
                for i in range(n)
            ]
            for g, r in enumerate(rooms(s)):
                push = row.stiff * max(-r, 0.0) ** row.power
                if g in pushing:
                    push += stiff[g] * (length[g] - r)
                total[g] += push
                if g > 0:
                    total[g - 1] -= push
            return [*v, *(f / m for f, m in zip(total, row.mass, strict=True))]

        return slope

    def full(g: int) -> Any:
        def value(_t: float, y: Any) -> float:
            return rooms(y[:n])[g] - length[g]

        value.terminal, value.direction = True, 1.0  # type: ignore[attr-defined]
        return value

    t, y = 0.0, np.array([0.0] * n + list(row.v))
    while t < until:
        falls = sorted(on)
        watched = [full(g) for g in falls]
        done = solve_ivp(
            field_of(frozenset(on)),
            (t, until),
            y,
            events=watched,
            **TIGHT,  # type: ignore[call-overload]
        )
        t, y = float(done.t[-1]), done.y[:, -1]
        for g, times in zip(falls, done.t_events, strict=True):
            if len(times):
                on.discard(g)
                fell[g] = t
    return Ended(list(y[:n]), list(y[n:]), fell)
