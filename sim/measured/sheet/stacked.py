"""Runs that stand below each other in one table, and the figures that programs add to a run.

    Time (s), Position 1 (m), Position 2 (m)
    0.00, …                                        rows of the first run
    Mean, 0.53, 0.91                               no reading: left out
    Run 2
    Time (s), Position 1 (m), Position 2 (m)       the heads again, or the name of the run alone
    0.00, …

A line of words that is none of these stays, and is refused as a reading with its line.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sim.measured.sheet import cells
from sim.measured.sheet.cells import CellRow
from sim.measured.sheet.prefixes import run_alone

_FIGURES = frozenset((
    "min", "minimum", "max", "maximum", "mean", "average", "avg", "median", "std", "stdev", "sd",
    "sum", "total", "count", "range", "mittelwert", "mittel", "maximalwert", "minimalwert",
    "standardabweichung", "summe", "anzahl", "moyenne", "écart-type", "somme", "media", "promedio",
    "mediana", "suma", "purata", "jumlah",
    "平均", "平均值", "最大", "最大值", "最小", "最小值", "标准差",
))  # fmt: skip
"""What stands before a figure of all readings, in the place of their time."""

_TITLES = ("statistics", "statistik", "statistiques", "estadística")


@dataclass(frozen=True, slots=True)
class Start:
    """Where a run begins among the rows of numbers, and what it is called; empty: by its place."""

    row: int
    run: str = ""


def without_figures(rows: Sequence[CellRow]) -> list[CellRow]:
    """The rows without those that hold a mean, a maximum and the like of the readings."""
    return [row for row in rows if not _is_figure(row)]


def _is_figure(row: CellRow) -> bool:
    words = row.first.casefold().replace(".", "").strip(" :=").removesuffix(" dev")
    if len(row.cells) == 1:
        return words in _TITLES
    return words in _FIGURES and any(map(cells.is_number, row.cells[1:]))


def stacked(rows: Sequence[CellRow], above: Sequence[CellRow]) -> tuple[list[CellRow], list[Start]]:
    """The rows of numbers of all runs, and where each begins; `above`: the rows above the first.

    A row that stands above it stands above another run where it is repeated, and so does a row
    that names a run.
    """
    heads = {_folded(row) for row in above}
    first = next((run for row in above if (run := _named(row))), "")
    data: list[CellRow] = []
    starts = [Start(0, first)]
    begins: str | None = None  # the name of the run that the next row begins, if it does
    for row in rows:
        run = _named(row)
        if run or _folded(row) in heads:
            begins = run or begins or ""
            continue
        if begins is not None:
            starts.append(Start(len(data), begins))
            begins = None
        data.append(row)
    return data, starts


def _named(row: CellRow) -> str:
    filled = [cell for cell in row.cells if cell]
    return run_alone(filled[0]) if len(filled) == 1 else ""


def _folded(row: CellRow) -> tuple[str, ...]:
    return tuple(cell.casefold() for cell in row.cells)


def names(starts: Sequence[Start]) -> tuple[str, ...]:
    """What the runs are called: as they say where all do, each by another name, else 1, 2, 3."""
    told = tuple(start.run for start in starts)
    if all(told) and len(set(told)) == len(told):
        return told
    return tuple(str(place) for place in range(1, len(starts) + 1))
