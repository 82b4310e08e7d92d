"""Any number of carts under the paper's law, integrated: the independent oracle for clusters.

Every pair whose overlap is positive pushes with k d + c d'; scipy's DOP853 at 1e-12 stops at every
sign change of a gap. Nothing of `sim.dynamics` is used.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp


def integrate(masses, positions, velocities, *, e, k, until, left=None, right=None, length=0.2):
    """Final positions and velocities; `left` and `right` are wall positions or None."""
    n = len(masses)
    masses = np.array(masses, float)
    walls = [left is not None, *([True] * (n - 1)), right is not None]
    mu = np.full(n + 1, np.nan)
    mu[0], mu[n] = masses[0], masses[-1]
    mu[1:n] = masses[:-1] * masses[1:] / (masses[:-1] + masses[1:])
    zeta = -math.log(e) / math.hypot(math.pi, math.log(e)) if e < 1 else 0.0
    c = 2 * zeta * np.sqrt(k * mu)

    def gaps(x, v):
        edges = np.full(n + 1, np.inf), np.zeros(n + 1)
        edges[0][1:n] = x[1:] - x[:-1] - length
        edges[1][1:n] = v[1:] - v[:-1]
        if left is not None:
            edges[0][0], edges[1][0] = x[0] - length / 2 - left, v[0]
        if right is not None:
            edges[0][n], edges[1][n] = right - x[-1] - length / 2, -v[-1]
        return edges

    def slope(active):
        def f(_t, y):
            x, v = y[:n], y[n:]
            room, rate = gaps(x, v)
            push = np.where(active, -k * np.where(active, room, 0.0) - c * rate, 0.0)
            push = np.nan_to_num(push)
            return np.concatenate([v, (push[:-1] - push[1:]) / masses])

        return f

    def crossing(index):
        def g(_t, y):
            return gaps(y[:n], y[n:])[0][index]

        g.terminal = True
        return g

    watched = [crossing(i) for i in range(n + 1) if walls[i]]
    t, y = 0.0, np.concatenate([positions, velocities]).astype(float)
    w = math.sqrt(k / mu[~np.isnan(mu)].min())
    while t < until:
        room, rate = gaps(y[:n], y[n:])
        near = np.abs(room) < 1e-11
        active = np.where(near, rate < 0, room < 0) & np.array(walls)
        ahead = min(until, t + 1e-9 / w)  # step off the zero, then watch again
        y = solve_ivp(slope(active), (t, ahead), y, method="DOP853", rtol=1e-12, atol=1e-14).y[
            :, -1
        ]
        t = ahead
        if t >= until:
            break
        found = solve_ivp(
            slope(active),
            (t, until),
            y,
            method="DOP853",
            rtol=1e-12,
            atol=1e-14,
            events=watched,
            max_step=0.1 / w if active.any() else 0.02,
        )
        t, y = found.t[-1], found.y[:, -1]
    return y[:n], y[n:]
