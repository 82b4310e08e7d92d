"""Power series of a row of bodies that push each other: exact to rounding, without an eigen-solver.

For the touching gaps k = 0 … p between bodies, with overlap o and one linear branch of force each,

    N_k = kappa_k (o_k − rest_k) + gamma_k o_k'  (+ springs and magnets across the gap)
    a_i = (N_left − N_right + F_i) / m_i     F_i = steady − linear v_i − quadratic v_i²
    o_k'' = a_left − a_right

every Taylor coefficient follows from the two before it. Over a step h with W h <= REACH, where W
bounds the fastest rate in the row, the coefficients fall like REACH^n / n!, and ORDER of them leave
less than a rounding error. The polynomial is the dense output too: events are found on it, and the
page draws it. Overlaps are series of their own, not differences of positions: a disturbance of
1e-30 m at the far end of a chain keeps all its figures.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from operator import mul

from sim.dynamics.motion.locked import hold, locked_runs
from sim.dynamics.motion.power_series.polynomial import Poly
from sim.effects.forces import PairForce
from sim.laws.branch import Branch

ORDER = 26
REACH = 2.0
"""REACH^ORDER / ORDER! is 2e-19: a thousandth of the rounding of the sum itself."""


@dataclass(slots=True)
class SettledRow:
    """Bodies in a row with all that acts on them, at the beginning of a step.

    `inverse` is 1/m, 0 for what does not move; `quadratic` is signed: −quadratic v² acts.
    """

    inverse: list[float]
    speeds: list[float]
    overlaps: list[float]
    rates: list[float]
    branches: list[Branch]
    links: list[tuple[PairForce, ...]]
    steady: list[float]
    linear: list[float]
    quadratic: list[float]

    @property
    def nonlinear(self) -> bool:
        """Does the series have a finite radius of convergence?"""
        return any(self.quadratic) or any(not link.linear for links in self.links for link in links)


@dataclass(slots=True)
class Expansion:
    """Series of one step: overlaps, contact forces, link forces, accelerations of the bodies.

    [] of a gap without links.
    """

    over: list[Poly]
    force: list[Poly]
    pull: list[Poly]
    bodies: list[Poly]


def step_length(row: SettledRow) -> float:
    """s. A step within which the linear part of the series converges to rounding."""
    count = len(row.branches)
    stiff, damp = [], []
    for k, branch in enumerate(row.branches):
        bounds = [link.bounds(-row.overlaps[k]) for link in row.links[k] if link.linear]
        stiff.append(branch.kappa + math.fsum([b[0] for b in bounds]))
        damp.append(branch.gamma + math.fsum([b[1] for b in bounds]))
    fastest = 0.0
    for i, inv in enumerate(row.inverse):
        drag = row.linear[i] + 2.0 * abs(row.quadratic[i] * row.speeds[i])
        fastest = max(fastest, inv * drag)
    for k in range(count):
        left, right = row.inverse[k], row.inverse[k + 1]
        s, d = stiff[k] * (left + right), damp[k] * (left + right)
        if k > 0:
            s += stiff[k - 1] * left
            d += damp[k - 1] * left
        if k + 1 < count:
            s += stiff[k + 1] * right
            d += damp[k + 1] * right
        d += max(row.linear[k] * left, row.linear[k + 1] * right)
        fastest = max(fastest, 0.5 * d + math.sqrt(0.25 * d * d + s))
    return REACH / fastest if fastest > 0.0 else math.inf


CONVERGED = 0.24
"""Of the radius of convergence: 0.24^26 is 8e-17."""


def converged_step(row: SettledRow, found: Expansion, speeds: list[Poly], longest: float) -> float:
    """s. For a nonlinear row: a part of the radius of convergence that the last terms show."""
    step = longest
    watched = [over for over, links in zip(found.over, row.links, strict=True) if links]
    for terms in (*watched, *speeds):
        first = next((n for n, c in enumerate(terms) if c != 0.0), len(terms))
        for n in (len(terms) - 2, len(terms) - 1):
            if n > first and terms[n] != 0.0:
                radius = root(abs(terms[first]) / abs(terms[n]), n - first)
                step = min(step, CONVERGED * radius)
    return step


def root(x: float, n: int) -> float:
    """The n-th root of x > 0; of x 2^(kn) it is 2^k times that, to the last bit.

    So a step is as long in other units, powers of 2, as it is in these.
    """
    part, power = math.frexp(x)
    whole, rest = divmod(power, n)
    return math.ldexp(math.ldexp(part, rest) ** (1.0 / n), whole)


def expand(row: SettledRow, led: list[Poly] | None = None) -> Expansion:
    """Series of overlaps, forces, and accelerations of all bodies (0 for what does not move).

    `led`: how overlaps of locked gaps change nevertheless, o'' of each; [] where they do not.
    """
    branches, inverse = row.branches, row.inverse
    count = len(branches)
    runs = locked_runs(branches)
    over = [[o, r] for o, r in zip(row.overlaps, row.rates, strict=True)]
    speed = [[v] for v in row.speeds]
    force: list[Poly] = [[] for _ in branches]
    pull: list[Poly] = [[0.0] * (ORDER - 1) if links else [] for links in row.links]
    linked = [
        (k, [link.expansion() for link in links], over[k], pull[k])
        for k, links in enumerate(row.links)
        if links
    ]
    bodies: list[Poly] = [[] for _ in inverse]
    dragged = any(row.linear) or any(row.quadratic)
    nothing = [0.0] * len(inverse)
    sizes = [0.0] * len(inverse)
    loaded = dragged or bool(linked) or any(row.steady)
    contacts = [
        (branch.kappa, branch.gamma, branch.rest, o, pushes)
        for branch, o, pushes in zip(branches, over, force, strict=True)
    ]
    moving = list(zip(inverse, bodies, strict=True))
    gaps = [(b.locked, o, own) for b, o, own in zip(branches, over, bodies[1:], strict=True)]
    for n in range(ORDER - 1):
        outside = list(nothing if n else row.steady)
        _add_pushes(contacts, n)
        if dragged:
            add_drag(row, speed, outside, n)
        if linked:
            _add_links(linked, outside, n)
        for run in runs:
            hold(run, force, inverse, outside, n, led)
        from_left = 0.0
        for i, (inv, own) in enumerate(moving):
            from_right = force[i][n] if i < count else 0.0
            a = (from_left - from_right + outside[i]) * inv
            if loaded:
                sizes[i] = (abs(from_left) + abs(from_right) + abs(outside[i])) * inv
            own.append(a)
            if dragged:
                speed[i].append(a / (n + 1))
            from_left = from_right
        scale = 1.0 / ((n + 1) * (n + 2))
        before = bodies[0][n]
        for k, (locked, o, own) in enumerate(gaps):
            after = own[n]
            relative = before - after
            if led is not None and led[k]:
                relative = led[k][n]
            elif locked or (loaded and is_rounding(relative, sizes[k] + sizes[k + 1])):
                relative = 0.0
            o.append(relative * scale)
            before = after
    return Expansion(over, force, pull, bodies)


ALIKE = 1e-15
"""Relative, of all the forces that add up to an acceleration. Two bodies that gravity or drag
accelerates alike keep their distance: what rounding leaves of the difference would part them, or
press them together."""


def is_rounding(difference: float, value: float) -> bool:
    """Whether `difference` is rounding beside accelerations [m/s²] of size `value`."""
    return abs(difference) <= ALIKE * abs(value)


def _add_pushes(contacts: list[tuple[float, float, float, Poly, Poly]], n: int) -> None:
    """The n-th coefficients of the contact forces, from those of the overlaps."""
    for kappa, gamma, rest, o, pushes in contacts:
        push = kappa * (o[n] if n else o[0] - rest)
        if gamma:
            push += gamma * (n + 1) * o[n + 1]
        pushes.append(push)


def _add_links(
    linked: list[tuple[int, list[Callable[[int, Poly], float]], Poly, Poly]],
    outside: list[float],
    n: int,
) -> None:
    """The n-th coefficients of springs and magnets across the gaps that have some."""
    before, from_left = -2, 0.0
    for i, links, o, pulls in linked:
        if i != before + 1:
            outside[before + 1] += from_left
            from_left = 0.0
        pull = links[0](n, o) if len(links) == 1 else math.fsum([term(n, o) for term in links])
        pulls[n] = pull
        outside[i] += from_left - pull
        before, from_left = i, pull
    outside[before + 1] += from_left


def add_drag(row: SettledRow, speed: list[Poly], outside: list[float], n: int) -> None:
    """The n-th coefficients of −linear v − quadratic v²."""
    for i, v in enumerate(speed):
        drag = row.linear[i] * v[n]
        if row.quadratic[i]:
            drag += row.quadratic[i] * sum(map(mul, v, v[n::-1]))
        outside[i] -= drag
