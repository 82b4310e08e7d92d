"""`make bench`: ratios and sizes as a table, and as `build/bench.json`.

    python -m tests.benchmarks [AREA ...]

Every module of this folder with a function `rows()` is an area. A row is a dictionary with `name`,
`value`, `unit`, `goal` (None where there is none) and `reference`, what it was measured against.
The goal is an upper bound, or a lower one with `"at_least": True`. A missed goal is marked, and is
not an error.
"""

from __future__ import annotations

import importlib
import json
import os
import pkgutil
import platform
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
Row = dict[str, Any]


def areas() -> list[str]:
    """The names of all areas."""
    found = (module.name for module in pkgutil.iter_modules([str(Path(__file__).parent)]))
    return sorted(name for name in found if not name.startswith("_"))


def missed(row: Row) -> bool:
    """Whether the row has a goal and does not reach it."""
    if row["goal"] is None:
        return False
    return bool(row["value"] < row["goal"] if row.get("at_least") else row["value"] > row["goal"])


def goal_text(row: Row) -> str:
    """The goal as the table shows it."""
    if row["goal"] is None:
        return ""
    return f"{'≥' if row.get('at_least') else '≤'} {row['goal']:.3g}"


def table(rows: Iterable[Row]) -> str:
    """The rows as aligned text; a missed goal has a cross."""
    cells = [("", "what", "value", "goal", "unit", "measured against")]
    for row in rows:
        mark = "✗" if missed(row) else " " if row["goal"] is None else "✓"
        value = f"{row['value']:.3g}"
        cells.append((mark, row["name"], value, goal_text(row), row["unit"], row["reference"]))
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    lines = ("  ".join(c.ljust(w) for c, w in zip(line, widths, strict=True)) for line in cells)
    return "\n".join(line.rstrip() for line in lines)


def main(chosen: list[str]) -> int:
    """Run the chosen areas, or all of them. Returns the exit code."""
    known = areas()
    if unknown := sorted(set(chosen) - set(known)):
        print(f"no area {', '.join(unknown)}; there are: {', '.join(known)}", file=sys.stderr)
        return 2
    rows: list[Row] = []
    for name in chosen or known:
        module = importlib.import_module(f"tests.benchmarks.{name}")
        if not hasattr(module, "rows"):
            continue
        print(f"measuring {name} …", file=sys.stderr, flush=True)
        rows += module.rows()
    print(table(rows))
    machine = f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores, Python "
    result = {"format": 1, "machine": machine + platform.python_version(), "rows": rows}
    target = ROOT / "build" / "bench.json"
    target.parent.mkdir(exist_ok=True)
    target.write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
