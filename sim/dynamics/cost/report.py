"""The work-precision table as one plain JSON object, format 1."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from sim.dynamics.cost.digits import one_more_digit
from sim.dynamics.cost.exact import Exact
from sim.dynamics.cost.measure import CostRow, NotRun
from sim.dynamics.report.document import FORMAT, finite
from sim.dynamics.stepping.methods import MethodChoice


def row_object(row: CostRow) -> dict[str, Any]:
    """One row; `step` in s, or `rtol`; errors in SI."""
    found = {
        "method": row.method,
        **_size(row),
        "order": row.order,
        "evaluations": row.evaluations,
        "time_ratio": row.time_ratio,
        "error_v": row.error_v,
        "error_x": row.error_x,
        "energy_error": row.energy_error,
        "delivered_e": row.delivered_e,
        "delivered_e_range": list(row.delivered) if row.delivered else None,
    }
    return {key: finite(value) for key, value in found.items()}


def _size(of: CostRow | MethodChoice) -> dict[str, float | None]:
    return {"rtol": of.rtol} if of.rtol is not None else {"step": of.step}


def floor_of(truth: Exact) -> float:
    """m/s. Half a step of a double at the scene's greatest speed: rounding that speed errs by it.
    A velocity that is less at the end is rounded more finely, and may err by less."""
    return 0.5 * math.ulp(truth.fastest)


def digits_of(rows: Iterable[dict[str, Any]], truth: Exact) -> dict[str, dict[str, float]]:
    """What one more digit costs, by method, out of rows as `row_object` writes them.

    `digits`: a digit of v. Where all carts end at rest every method gets v right that stops them,
    with any step: there it has no method, and `digits_x` is a digit of x.
    """
    rows = list(rows)
    if not truth.rests:
        return {"digits": _slopes(rows, "error_v", truth.fastest)}
    return {"digits": {}, "digits_x": _slopes(rows, "error_x", truth.way)}


def _slopes(rows: Iterable[dict[str, Any]], error: str, whole: float) -> dict[str, float]:
    told = ((row["method"], row["time_ratio"], row[error]) for row in rows)
    return {method: float(f"{by:.3g}") for method, by in one_more_digit(told, whole).items()}


def cost_report(
    title: str, rows: Sequence[CostRow], truth: Exact, not_run: Sequence[NotRun] = ()
) -> dict[str, Any]:
    """What `carts cost --json` prints. `proved`: errors are those against a certificate. `not_run`:
    methods that cannot follow the scene."""
    objects = [row_object(row) for row in rows]
    return {
        "format": FORMAT,
        "scene": title,
        "proved": truth.proved,
        "floor": floor_of(truth),
        **digits_of(objects, truth),
        "rows": objects,
        "not_run": [
            {"method": one.choice.method, **_size(one.choice), "reason": one.reason}
            for one in not_run
        ],
    }
