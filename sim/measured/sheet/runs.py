"""Several runs in one file: one is read, the others are named."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from sim.measured.refusal import refuse
from sim.measured.sheet import stacked
from sim.measured.sheet.table import Table
from sim.measured.sheet.wrapped import counted_on
from sim.measured.track import FEWEST
from sim.scene.said import said


@dataclass(frozen=True, slots=True)
class OneRun:
    """The table of one run, its name, and those of all that stand in the file."""

    table: Table
    run: str
    runs: tuple[str, ...]
    clocks: tuple[str, ...] = ()

    @property
    def notes(self) -> list[str]:
        """For the reader: of other runs, and of clocks that began anew."""
        left = ", ".join(run for run in self.runs if run != self.run)
        if not left:
            return list(self.clocks)
        others = said("run {run} is read; other runs in the file: {runs}", run=self.run, runs=left)
        return [others, *self.clocks]


def of_one_run(table: Table, asked: str) -> OneRun:
    """One of the runs that stand side by side or below each other: the one that was asked for, else
    the first that is long enough; raises ReadingError where there are several and another was asked
    for. A column without a label is of the run to its left; before all, it is for each. Clocks that
    begin anew within it are counted on.
    """
    one = _one_of(table, asked)
    read, clocks = counted_on(one.table)
    return replace(one, table=read, clocks=tuple(clocks))


def _one_of(table: Table, asked: str) -> OneRun:
    if len(table.starts) > 1:
        return _of_those_below(table, asked)
    labels, current = [], ""
    for column in table.columns:
        current = column.run or current
        labels.append(current)
    runs = tuple(dict.fromkeys(filter(None, labels)))
    if len(runs) < 2:
        return OneRun(table, "".join(runs), runs)
    wanted = asked or next((run for run in runs if _long(table, labels, run)), runs[0])
    read = runs[run_place(wanted, runs)]
    pairs = zip(table.columns, labels, strict=True)
    kept = tuple(column for column, label in pairs if label in ("", read))
    return OneRun(replace(table, columns=kept), read, runs)


def _long(table: Table, labels: Sequence[str], run: str) -> bool:
    """Whether each column of this run has readings enough: a run may have been stopped at once."""
    its = [c.values for c, label in zip(table.columns, labels, strict=True) if label == run]
    return all(sum(value is not None for value in values) >= FEWEST for values in its)


def _of_those_below(table: Table, asked: str) -> OneRun:
    runs = stacked.names(table.starts)
    ends = [start.row for start in table.starts[1:]] + [len(table.lines)]
    spans = [slice(start.row, end) for start, end in zip(table.starts, ends, strict=True)]
    long = (k for k, rows in enumerate(spans) if rows.stop - rows.start >= FEWEST)
    place = run_place(asked, runs) if asked else next(long, 0)
    rows = spans[place]
    columns = tuple(replace(column, values=column.values[rows], run="") for column in table.columns)
    one = replace(table, columns=columns, lines=table.lines[rows], starts=())
    return OneRun(one, runs[place], runs)


def run_place(asked: str, runs: Sequence[str]) -> int:
    """Where a run stands among these: by its name, else its place from 1; raises ReadingError."""
    if not asked:
        return 0
    names = [run.casefold() for run in runs]
    if asked.casefold() in names:
        return names.index(asked.casefold())
    if asked.isdecimal() and 1 <= int(asked) <= len(runs):
        return int(asked) - 1
    reason = said("there is no run {run}: this file has {count}", run=asked, count=str(len(runs)))
    raise refuse(1, reason, said("its runs: {runs}", runs=", ".join(runs[:8])))
