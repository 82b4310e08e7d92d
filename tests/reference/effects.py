"""Any row of carts under any effects, integrated: the independent oracle of all solvers.

scipy's DOP853 at 1e-12 integrates from one change of formula to the next. Changes are found by
looking at signs on the dense output, so that several at one instant are taken one after the other.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.integrate import DOP853

from sim.scene import Scene
from tests.reference.contact_branches import UnsupportedError
from tests.reference.dead_bumpers import HeldRow
from tests.reference.one_instant import hold_on, strike_all
from tests.reference.row_of_carts import NOTHING, Row

Watched = list[tuple[float, Any]]

LOOKS = 6
"""Samples of one step at which signs are looked at."""


REST = 1e-6
"""m/s. An impact that is slower is one of a contact that something presses: infinitely many."""


@dataclass
class Answer:
    x: list[float]
    v: list[float]
    work: dict[str, float]
    changes: int = 0
    record: list[tuple[float, list[float], list[float]]] = field(default_factory=list)


ERRORS = (1e-12, 1e-14)
"""Of one step: relative, and in m and m/s."""

FINE = (1e-13, 1e-16)
"""Where a stiff contact swings by less than a micrometre for long."""


def integrate(
    scene: Scene, *, most_steps: int = 4000, marks: tuple[float, ...] = (), fine: bool = False
) -> Answer:
    """Positions and velocities at the end, the work of each kind, and states at the marks."""
    row = HeldRow(scene)
    row.errors = FINE if fine else ERRORS
    strike_all(row)
    hold_on(row)
    row.judge()
    times = {scene.until, *(t for t in marks if t < scene.until)}
    for e in row.acting.of["push"]:
        times |= {t for t in (e.numbers.get("from", 0.0), e.numbers.get("until")) if t}
    times |= {t for t, _, _ in row.acting.releases}
    answer = Answer([], [], {})
    budget = [most_steps]
    for end in sorted(t for t in times if t <= scene.until):
        _advance(row, end, budget)
        strike_all(row)
        for at, k, e in row.acting.releases:
            if at == end:
                row.release(k, e.numbers["energy"])
                strike_all(row)
        hold_on(row)
        row.judge()
        if end in marks:
            answer.record.append((end, list(row.x), list(row.v)))
    answer.x, answer.v = list(row.x), list(row.v)
    answer.work = dict(zip(row.kinds, row.work, strict=True))
    answer.changes = row.changes
    return answer


def _advance(row: Row, end: float, budget: list[int]) -> None:
    stuck = 0
    while row.t < end:
        y0 = np.array([*row.x, *row.v, *row.work])
        for value, what in row.watches(y0):
            if value < -NOTHING:
                _change(row, what)
                break
        else:
            before = row.t
            what = _segment(row, y0, end, budget)
            stuck = stuck + 1 if row.t == before else 0
            if stuck > 50:
                raise UnsupportedError("changes without end")
            if what is not None:
                _change(row, what)
            continue
        stuck += 1
        if stuck > 50:
            raise UnsupportedError("changes without end")


def _change(row: Row, what: tuple[str, int]) -> None:
    if what[0] == "hit":
        if row.overlap(what[1], row.x, row.v)[1] < REST and not row.scene.contacts[what[1]].joins:
            raise UnsupportedError("an instant contact at rest")
        strike_all(row, what[1])
    row.change(what)
    if hold_on(row):
        row.judge()


def _segment(row: Row, y: Any, end: float, budget: list[int]) -> Any:
    """Integrate until a watch turns negative or the end; returns what happened."""

    def solver(y: Any, t: float, until: float) -> DOP853:
        return DOP853(
            lambda _t, y: row.slope(y),
            t,
            y,
            until,
            rtol=row.errors[0],
            atol=row.errors[1],
            max_step=_quickest(row),
            first_step=None if until - t > 1e-9 else until - t,
        )

    run = solver(y, row.t, end)
    while run.status == "running":
        budget[0] -= 1
        if budget[0] < 0:
            raise UnsupportedError("too many steps")
        y_old, t_old = run.y.copy(), run.t
        if run.step():
            raise UnsupportedError("the integration failed")
        dense = run.dense_output()
        low = t_old
        looks = [t_old + (run.t - t_old) * look / LOOKS for look in range(1, LOOKS)] + [run.t]
        seen = _seen(dense, [t_old, *looks])
        before = row.watches(seen[0][0])
        for t, states in zip(looks, seen, strict=True):
            now = row.watches(states[3])
            judged = now if t < run.t else row.watches(run.y)
            fallen = [what for value, what in judged if value < -NOTHING]
            until = t
            if not fallen and (grazed := _grazed(row, dense, (low, t), (before, now), states)):
                until, fallen = grazed
            if fallen:
                when, what = min(
                    ((_root(row, dense, low, until, what), what) for what in fallen),
                    key=lambda pair: pair[0],
                )
                if when > t_old:  # once more, to exactly there: dense output is less accurate
                    again = solver(y_old, t_old, when)
                    while again.status == "running":
                        again.step()
                    y_old = again.y
                _keep(row, when, y_old)
                return what
            low, before = t, now
    _keep(row, end, run.y)
    return None


def _keep(row: Row, t: float, y: Any) -> None:
    n = row.n
    row.t = t
    row.x, row.v, row.work = list(y[:n]), list(y[n : 2 * n]), list(y[2 * n :])


def _root(row: Row, dense: Any, low: float, high: float, what: Any) -> float:
    def value(t: float) -> float:
        return next(v for v, w in row.watches(dense(t)) if w == what)

    if value(low) < 0:
        return low
    for _ in range(60):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if value(middle) >= 0 else (low, middle)
    return high


def _seen(dense: Any, times: list[float]) -> Any:
    """The states at the ends of each span between these times and a little inside of them, as
    `_grazed` wants them: all asked for at once, which takes hardly longer than one."""
    spans = [(low, low + _aside(low, high), high - _aside(low, high), high)
             for low, high in pairwise(times)]  # fmt: skip
    return dense(np.ravel(spans)).T.reshape(len(spans), 4, -1)


def _aside(low: float, high: float) -> float:
    """s. How far inside of the ends of a span slopes are looked for."""
    return 1e-4 * (high - low)


def _grazed(
    row: Row, dense: Any, span: tuple[float, float], ends: tuple[Watched, Watched], states: Any
) -> tuple[float, list[Any]] | None:
    """A watch that is positive at both looks and negative between them: a touch that is soon over.

    Told by slopes: down at the first look, up at the second, and steep enough to get there.
    `ends`: what was watched at both looks, `states`: at these, and inside of them.
    """
    low, high = span
    aside = _aside(low, high)
    here, there = ends
    after, before = row.watches(states[1]), row.watches(states[2])
    if not len(here) == len(after) == len(before) == len(there):
        return None
    for (v0, what), (v1, _), (v2, _), (v3, _) in zip(here, after, before, there, strict=True):
        down, up = (v1 - v0) / aside, (v3 - v2) / aside
        if down < 0 < up and min(v0, v3) > -NOTHING and v0 + down * (high - low) < 0:
            deepest = _lowest(row, dense, low, high, what)
            if any(value < -NOTHING for value, its in row.watches(dense(deepest)) if its == what):
                return deepest, [what]
    return None


def _lowest(row: Row, dense: Any, low: float, high: float, what: Any) -> float:
    """Where this watch is lowest, by thirds."""

    def value(t: float) -> float:
        return next(v for v, w in row.watches(dense(t)) if w == what)

    for _ in range(60):
        third = (high - low) / 3.0
        if value(low + third) < value(high - third):
            high -= third
        else:
            low += third
    return 0.5 * (low + high)


def _quickest(row: Row) -> float:
    """s. A step in which nothing happens that six looks would miss."""
    rate = 10.0
    for k, branch in row.branches.items():
        if branch is not None and branch.state not in ("open", "idle"):
            rate = max(rate, branch.rates(row.mu(k)))
    for k, e in row.acting.links:
        if e.kind == "spring":
            mu = row.mu(k)
            rate = max(rate, math.sqrt(e.numbers["stiffness"] / mu))
            rate = max(rate, e.numbers.get("damping", 0.0) / mu)
    return 0.4 / rate
