"""A country: a report on a million answers, 100,000 files as a table, sums of 1,000 schools.

Only where it is asked for by name: it takes a quarter of an hour and 5 GB of the disk. Times and
peaks of memory are those of the command in a process of its own. CARTS_COUNTRY, a number such as
0.01, makes all of it smaller, to try this module.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
ONLY_ASKED = True
SCALE = float(os.environ.get("CARTS_COUNTRY", "1"))
ANSWERS, FILES, SCHOOLS = (round(n * SCALE) for n in (1_000_000, 100_000, 1_000))
STUDENTS = 20
"""Of a school whose sums are added."""


def rows() -> list[dict[str, Any]]:
    """One row per goal."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        return [*_table(folder / "table"), *_files(folder / "files"), *_sums(folder / "sums")]


def _table(folder: Path) -> list[dict[str, Any]]:
    _make(f"write_answers(Path({str(folder)!r}), {ANSWERS})")
    report, took, peak = _measured(["class", "--table", str(folder), "--json"])
    what = f"report on a table of {ANSWERS:,} answers, {report['files']['counted']:,} files"
    return [_row(what, took, "s", 60), _row(f"{what}, memory", peak, "MB", 2_000)]


def _files(folder: Path) -> list[dict[str, Any]]:
    _make(f"write_files(Path({str(folder)!r}), {FILES})")
    table = folder.parent / "made"
    words = ["class", str(folder), "--parquet", str(table), "--json"]
    report, took, peak = _measured(words)
    what = f"{report['files']['counted']:,} files of 50 kB into a table, and its report"
    return [_row(what, took, "s", 720), _row(f"{what}, memory", peak, "MB", 500)]


def _sums(folder: Path) -> list[dict[str, Any]]:
    folder.mkdir()
    _make(f"write_summaries(Path({str(folder)!r}), {SCHOOLS}, {STUDENTS})")
    paths = sorted(map(str, folder.glob("*.json")))
    report, took, peak = _measured(["class", "--merge", *paths, "--json"])
    whole, _, _ = _measured(["class", "--table", str(folder / "whole"), "--json"])
    unequal = sum(one != other for one, other in zip(
        _numbers(report["lessons"]), _numbers(whole["lessons"]), strict=True))  # fmt: skip
    what = f"sums of {len(paths):,} schools added"
    return [
        _row(what, took, "s", 10), _row(f"{what}, memory", peak, "MB", None),
        _row(f"{what}: numbers other than those of all answers at once", unequal, "", 0),
    ]  # fmt: skip


def _numbers(value: Any) -> list[Any]:
    """Every number, text and truth in it, in order; sums do not tell beliefs."""
    if isinstance(value, dict):
        return [one for name in sorted(value.keys() - {"beliefs"}) for one in _numbers(value[name])]
    if isinstance(value, list):
        return [len(value), *(one for part in value for one in _numbers(part))]
    return [value]


def _make(call: str) -> None:
    """In a process of its own: a child's peak of memory is never below that of its parent."""
    code = f"from pathlib import Path\nfrom tests.country.generator import *\n{call}"
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)


def _measured(words: Sequence[str]) -> tuple[dict[str, Any], float, float]:
    """The report, the seconds, and the peak of memory in MB."""
    start = time.perf_counter()
    call = [sys.executable, "-m", "sim", *words]
    with subprocess.Popen(call, stdout=subprocess.PIPE, cwd=ROOT) as running:
        assert running.stdout is not None
        report = json.loads(running.stdout.read())
        _, _, used = os.wait4(running.pid, 0)
        running.returncode = 0
    return report, time.perf_counter() - start, used.ru_maxrss / 1024


def _row(name: str, value: float, unit: str, goal: float | None) -> dict[str, Any]:
    return {"name": name, "value": value, "unit": unit, "goal": goal, "reference": "one run"}
