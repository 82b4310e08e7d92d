"""Power series of a row of bodies that push each other: exact to rounding, without an eigen-solver.

For the touching gaps k = 0 … p between bodies, with overlap o and one linear branch of force each,

    N_k = kappa_k (o_k − rest_k) + gamma_k o_k'
    a_i = (N_left − N_right) / m_i           o_k'' = a_left − a_right

every Taylor coefficient follows from the two before it. Over a step h with W h <= REACH, where W
bounds the fastest rate in the row, the coefficients fall like REACH^n / n!, and ORDER of them leave
less than a rounding error. The polynomial is the dense output too: events are found on it, and the
page draws it. Overlaps are series of their own, not differences of positions: a disturbance of
1e-30 m at the far end of a chain keeps all its figures.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from sim.dynamics.safe_step import SAFE_STEPS, safe_step

ORDER = 26
REACH = 2.0
"""REACH^ORDER / ORDER! is 2e-19: a thousandth of the rounding of the sum itself."""

Poly = list[float]
"""Coefficients of 1, t, t² …, t in s."""


@dataclass(frozen=True, slots=True)
class Branch:
    """One linear branch of a contact force; kappa in N/m, gamma in N s/m, rest in m.

    `locked`: the overlap stays as it is, and the force is whatever that takes (a bumper with e = 0
    at its greatest overlap). The forces of neighbouring locked gaps solve a tridiagonal system.
    """

    kappa: float
    gamma: float
    rest: float
    locked: bool = False


LOCKED = Branch(0.0, 0.0, 0.0, locked=True)


def step_length(masses: list[float], branches: list[Branch]) -> float:
    """s. A step within which the series converges to rounding. masses: of all bodies, in order."""
    fastest = 0.0
    for k, branch in enumerate(branches):
        left, right = 1.0 / masses[k], 1.0 / masses[k + 1]
        stiff = branch.kappa * (left + right)
        damp = branch.gamma * (left + right)
        if k > 0:
            stiff += branches[k - 1].kappa * left
            damp += branches[k - 1].gamma * left
        if k + 1 < len(branches):
            stiff += branches[k + 1].kappa * right
            damp += branches[k + 1].gamma * right
        fastest = max(fastest, 0.5 * damp + math.sqrt(0.25 * damp * damp + stiff))
    return REACH / fastest if fastest > 0.0 else math.inf


def expand(
    masses: list[float], overlaps: list[float], rates: list[float], branches: list[Branch]
) -> tuple[list[Poly], list[Poly], list[Poly]]:
    """Series of overlaps, forces, and accelerations of all bodies (0 for a wall: infinite mass)."""
    count = len(branches)
    runs = _locked_runs(branches)
    over = [[o, r] for o, r in zip(overlaps, rates, strict=True)]
    force: list[Poly] = [[] for _ in branches]
    bodies: list[Poly] = [[] for _ in masses]
    inverse = [1.0 / mass for mass in masses]
    for n in range(ORDER - 1):
        for k, branch in enumerate(branches):
            o = over[k]
            push = branch.kappa * (o[n] - branch.rest if n == 0 else o[n])
            if branch.gamma:
                push += branch.gamma * (n + 1) * o[n + 1]
            force[k].append(push)
        for run in runs:
            _hold(run, force, inverse, n)
        for i, inv in enumerate(inverse):
            from_left = force[i - 1][n] if i > 0 else 0.0
            from_right = force[i][n] if i < count else 0.0
            bodies[i].append((from_left - from_right) * inv)
        scale = 1.0 / ((n + 1) * (n + 2))
        for k in range(count):
            over[k].append((bodies[k][n] - bodies[k + 1][n]) * scale)
    return over, force, bodies


def _locked_runs(branches: list[Branch]) -> list[range]:
    """Neighbouring locked gaps, grouped."""
    runs: list[range] = []
    for k, branch in enumerate(branches):
        if branch.locked:
            if runs and runs[-1].stop == k:
                runs[-1] = range(runs[-1].start, k + 1)
            else:
                runs.append(range(k, k + 1))
    return runs


def _hold(run: range, force: list[Poly], inverse: list[float], n: int) -> None:
    """The n-th coefficients that keep all overlaps of a locked run: Thomas's algorithm.

    (1/mL + 1/mR) N_k − N_(k−1)/mL − N_(k+1)/mR = 0 for each k of the run.
    """
    ratio: list[float] = []
    right_side: list[float] = []
    for k in run:
        known = inverse[k] * force[k - 1][n] if k == run.start and k > 0 else 0.0
        if k == run.stop - 1 and k + 1 < len(force):
            known += inverse[k + 1] * force[k + 1][n]
        below = inverse[k] if k > run.start else 0.0
        pivot = inverse[k] + inverse[k + 1] - below * (ratio[-1] if ratio else 0.0)
        ratio.append(inverse[k + 1] / pivot)
        right_side.append((known + below * (right_side[-1] if right_side else 0.0)) / pivot)
    later = 0.0
    for j in range(len(run) - 1, -1, -1):
        later = right_side[j] + (ratio[j] * later if j < len(run) - 1 else 0.0)
        force[run[j]][n] = later


def value(p: Poly, t: float) -> float:
    """p(t) by Horner's rule."""
    total = 0.0
    for c in reversed(p):
        total = total * t + c
    return total


def size(p: Poly, h: float) -> float:
    """Bound on |p| over [0, h]."""
    total, power = 0.0, 1.0
    for c in p:
        total += abs(c) * power
        power *= h
    return total


def slope(p: Poly) -> Poly:
    """dp/dt."""
    return [n * c for n, c in enumerate(p)][1:] or [0.0]


def integral(p: Poly) -> Poly:
    """The primitive that is 0 at t = 0."""
    return [0.0, *(c / (n + 1) for n, c in enumerate(p))]


CLOSE = 2e-16
"""Relative to the step: a zero nearer than this is here."""


def first_fall(p: Poly, h: float) -> float | None:
    """First t in [0, h] at which p, positive just after 0, falls to zero; None if it does not.

    0 where p is negative just after 0. A zero of p at 0 itself is divided out, however many-fold.
    Found by steps that cannot jump over a zero: |p''| is bounded by its coefficients.
    """
    low = next((n for n, c in enumerate(p) if c != 0.0), None)
    if low is None:
        return None
    q = p[low:]
    if q[0] < 0.0:
        return 0.0
    if h <= 0.0:
        return None
    bound, power, reach = 0.0, 1.0, 0.0
    for n in range(1, len(q)):
        reach += abs(q[n]) * power * h
        if n >= 2:
            bound += n * (n - 1) * abs(q[n]) * power / h
        power *= h
    if q[0] > reach:
        return None
    rate = slope(q)
    t = 0.0
    for _ in range(SAFE_STEPS):
        here, falling = value(q, t), value(rate, t)
        if here <= 0.0:
            return t
        step = safe_step(here, falling, bound)
        if step <= CLOSE * h:
            return t
        t += step
        if t > h:
            return None
    return t
