"""Contacts that keep their overlap, and whatever force that takes; impacts that come at once."""

from __future__ import annotations

from sim.dynamics.motion.power_series.polynomial import Poly
from sim.laws.branch import Branch


def locked_runs(branches: list[Branch]) -> list[range]:
    """Neighbouring locked gaps, grouped."""
    runs: list[range] = []
    for k, branch in enumerate(branches):
        if branch.locked:
            if runs and runs[-1].stop == k:
                runs[-1] = range(runs[-1].start, k + 1)
            else:
                runs.append(range(k, k + 1))
    return runs


def hold_now(
    branches: list[Branch], push: list[float], inverse: list[float], outside: list[float]
) -> None:
    """Fill in the forces of locked gaps among the others, at one instant."""
    force = [[p] for p in push]
    for run in locked_runs(branches):
        hold(run, force, inverse, outside, 0)
    push[:] = [p[0] for p in force]


def hold(
    run: range,
    force: list[Poly],
    inverse: list[float],
    outside: list[float],
    n: int,
    led: list[Poly] | None = None,
) -> None:
    """The n-th coefficients that keep all overlaps of a locked run: Thomas's algorithm.

    (1/mL + 1/mR) N_k − N_(k−1)/mL − N_(k+1)/mR = F_L/mL − F_R/mR for each k of the run, F all that
    acts on a body besides contacts, less o_k'' where that is given. Between two bodies that do not
    move nothing presses: N = 0.
    """
    ratio: list[float] = []
    right_side: list[float] = []
    for k in run:
        known = outside[k] * inverse[k] - outside[k + 1] * inverse[k + 1]
        if led is not None and led[k]:
            known -= led[k][n]
        if k == run.start and k > 0:
            known += inverse[k] * force[k - 1][n]
        if k == run.stop - 1 and k + 1 < len(force):
            known += inverse[k + 1] * force[k + 1][n]
        below = inverse[k] if k > run.start else 0.0
        pivot = inverse[k] + inverse[k + 1] - below * (ratio[-1] if ratio else 0.0)
        if pivot <= 0.0:
            ratio.append(0.0)
            right_side.append(0.0)
            continue
        ratio.append(inverse[k + 1] / pivot)
        right_side.append((known + below * (right_side[-1] if right_side else 0.0)) / pivot)
    later = 0.0
    for j in range(len(run) - 1, -1, -1):
        later = right_side[j] + (ratio[j] * later if j < len(run) - 1 else 0.0)
        force[run[j]][n] = later


def impulses(inverse: list[float], closing: list[float], restitution: list[float]) -> list[float]:
    """N s in gaps side by side, hit at once: each closes with u m/s, and opens with e u after it.

    (1/mL + 1/mR) p_k − p_(k−1)/mL − p_(k+1)/mR = (1 + e_k) u_k: what forces are to accelerations,
    impulses are to velocities. `inverse`: 1/kg of the bodies; 0 for a wall. No impulse pulls.
    """
    found = [[0.0] for _ in closing]
    wanted = [[-(1.0 + e) * u] for u, e in zip(closing, restitution, strict=True)]
    hold(range(len(closing)), found, inverse, [0.0] * len(inverse), 0, wanted)
    return [p for (p,) in found]
