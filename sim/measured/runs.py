"""Several runs in one file: one is read, the others are named."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sim.measured.refusal import refuse
from sim.measured.table import Table


def of_one_run(table: Table, asked: str) -> tuple[Table, tuple[str, ...], list[str]]:
    """The columns of one of the runs that stand side by side, the names of all, and a note; raises
    ReadingError where there are several and another was asked for. A column without a label is of
    the run to its left; before all, it is for each.
    """
    labels, current = [], ""
    for column in table.columns:
        current = column.run or current
        labels.append(current)
    runs = tuple(dict.fromkeys(filter(None, labels)))
    if len(runs) < 2:
        return table, runs, []
    read = runs[run_place(asked, runs)]
    pairs = zip(table.columns, labels, strict=True)
    kept = tuple(column for column, label in pairs if label in ("", read))
    left = ", ".join(run for run in runs if run != read)
    note = f"run {read} is read; other runs in the file: {left}"
    return replace(table, columns=kept), runs, [note]


def run_place(asked: str, runs: Sequence[str]) -> int:
    """Where a run stands among these: by its name, else its place from 1; raises ReadingError."""
    if not asked:
        return 0
    names = [run.casefold() for run in runs]
    if asked.casefold() in names:
        return names.index(asked.casefold())
    if asked.isdecimal() and 1 <= int(asked) <= len(runs):
        return int(asked) - 1
    its = ", ".join(runs[:8])
    raise refuse(1, f"there is no run {asked}: this file has {len(runs)}", f"its runs: {its}")
