"""The work-precision table as one plain JSON object, format 1."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sim.dynamics.cost.measure import CostRow
from sim.dynamics.report.document import FORMAT, finite


def row_object(row: CostRow) -> dict[str, Any]:
    """One row; `step` in s, or `rtol`; errors in SI."""
    size = {"rtol": row.rtol} if row.rtol is not None else {"step": row.step}
    found = {
        "method": row.method,
        **size,
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


def cost_report(title: str, rows: Sequence[CostRow]) -> dict[str, Any]:
    """What `carts cost --json` prints."""
    return {"format": FORMAT, "scene": title, "rows": [row_object(row) for row in rows]}
