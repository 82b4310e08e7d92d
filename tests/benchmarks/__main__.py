"""`make bench`: ratios and sizes as a table, and as `build/bench.json`.

    python -m tests.benchmarks [AREA ...]

Every module of this folder with a function `rows()` is an area. A missed goal is marked, and is not
an error; nor is an area that cannot be measured here. A run of all areas is kept, and the page
*Measured* and the badges are made from it. An area with `ONLY_ASKED` is measured by its name alone.
"""

from __future__ import annotations

import importlib
import json
import os
import pkgutil
import platform
import subprocess
import sys
from collections.abc import Iterable
from datetime import UTC, datetime
from importlib import metadata
from pathlib import Path
from types import ModuleType
from typing import Any

from tests.benchmarks import _kept
from tests.benchmarks._rows import Row, goal_text, missed

ROOT = Path(__file__).parents[2]
BROWSERS = ("chromium", "firefox-esr")
PACKAGES = ("numpy", "scipy")


def areas() -> dict[str, ModuleType]:
    """The areas by name."""
    names = sorted(module.name for module in pkgutil.iter_modules([str(Path(__file__).parent)]))
    found = {
        name: importlib.import_module(f"tests.benchmarks.{name}")
        for name in names
        if not name.startswith("_")
    }
    return {name: module for name, module in found.items() if hasattr(module, "rows")}


def usual(known: dict[str, ModuleType]) -> dict[str, ModuleType]:
    """Those that are measured without being named."""
    return {n: module for n, module in known.items() if not getattr(module, "ONLY_ASKED", False)}


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


def measure(chosen: dict[str, ModuleType]) -> tuple[list[Row], dict[str, str]]:
    """The rows of all areas, each told when it is there, and why an area has none."""
    rows: list[Row] = []
    left_out: dict[str, str] = {}
    for name, module in chosen.items():
        _tell(f"measuring {name} …")
        try:
            for row in module.rows():
                rows.append({"area": name, **row})
                print(
                    f"  {row['name']}: {row['value']:.3g} {row['unit']}",
                    file=sys.stderr,
                    flush=True,
                )
        except Exception as error:  # whatever it is: the others are measured
            left_out[name] = f"{type(error).__name__}: {error}".splitlines()[0]
            _tell(left_out[name])
    return rows, left_out


def _tell(line: str) -> None:
    print(line, file=sys.stderr, flush=True)  # stdout holds the table alone


def about() -> dict[str, Any]:
    """The day, the machine, and what ran on it."""
    machine = f"{platform.system()} {platform.machine()}, {os.cpu_count()} cores"
    versions = {"Python": platform.python_version()}
    versions |= {name: metadata.version(name) for name in PACKAGES}
    for browser in BROWSERS:
        told = subprocess.run([browser, "--version"], capture_output=True, text=True, check=False)
        number = next((word for word in told.stdout.split() if word[:1].isdigit()), "")
        versions |= {browser: number} if number else {}
    return {
        "date": datetime.now(UTC).date().isoformat(),
        "machine": machine,
        "versions": versions,
    }


def main(asked: list[str]) -> int:
    """Run the areas asked for, or all of them. Returns the exit code."""
    known = areas()
    if unknown := sorted(set(asked) - set(known)):
        print(f"no area {', '.join(unknown)}; there are: {', '.join(known)}", file=sys.stderr)
        return 2
    chosen = {name: known[name] for name in asked} if asked else usual(known)
    rows, left_out = measure(chosen)
    print(table(rows))
    told = {name: title(module) for name, module in chosen.items() if name not in left_out}
    made = _kept.document(rows, told, left_out, about())
    target = ROOT / "build" / "bench.json"
    target.parent.mkdir(exist_ok=True)
    target.write_text(json.dumps(made, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    if not asked:
        _kept.keep(made)
    return 0


def title(module: ModuleType) -> str:
    """What an area is about: the first words of its module."""
    first = (module.__doc__ or "").split("\n\n")[0].replace("\n", " ")
    return first.partition(":")[0].rstrip(".")


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
