"""A row of a benchmark: `name`, `value`, `unit`, `goal` (None where there is none), `reference`.

The goal is an upper bound, or a lower one with `"at_least": True`.
"""

from __future__ import annotations

from typing import Any

Row = dict[str, Any]


def missed(row: Row) -> bool:
    """Whether the row has a goal and does not reach it."""
    if row["goal"] is None:
        return False
    return bool(row["value"] < row["goal"] if row.get("at_least") else row["value"] > row["goal"])


def goal_text(row: Row) -> str:
    """The goal as a table shows it."""
    if row["goal"] is None:
        return ""
    return f"{'≥' if row.get('at_least') else '≤'} {row['goal']:.3g}"
