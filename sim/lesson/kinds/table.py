"""A table to fill in: some cells are given, the others are numbers to be read off or worked out.

    columns: [push, velocity after 2 s]
    rows:
      - [0.1 N, {answer: 0.4 m/s, tolerance: 0.02 m/s}]
      - [0.2 N, {answer: 0.8 m/s, tolerance: 0.02 m/s}]
    plot: [push, velocity after 2 s]

Cells are marked one by one; the marks are given for the whole. A plot shows what has been typed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from sim.lesson import keys
from sim.lesson.keys import NUMBER_OR_TEXT, PROSE, Key
from sim.lesson.kinds.measured_number import (
    TOLERANCE,
    as_asked,
    read_right,
    read_unit,
)
from sim.lesson.kinds.number import mark_number
from sim.lesson.mark import Mark, all_or_nothing, is_empty
from sim.lesson.question import Common, Question
from sim.scene.problem import Path, Problem, meant
from sim.scene.prose import MARK
from sim.scene.tables import unknown_keys

CELL_KEYS = (
    Key("answer", "the right number with its unit", "0.8 m/s", NUMBER_OR_TEXT, True),
    TOLERANCE,
)
NUMBER_OR_PROSE = {"type": ["number", "string"], MARK: True}
MOST = 8  # columns, and rows: more does not fit a phone
HINT = "rows:\n    - [0.1 N, {answer: 0.4 m/s, tolerance: 0.02 m/s}]"


@dataclass(frozen=True, slots=True)
class Open:
    """A cell to fill in; numbers in `unit`."""

    answer: float
    tolerance: float
    unit: str
    units: Mapping[str, float]


Cell = str | Open


@dataclass(frozen=True, slots=True, kw_only=True)
class Table(Question):
    """The value is a table from the cell (`row-column`, from 1) to the number in its unit."""

    KIND: ClassVar[str] = "table"
    SAYS: ClassVar[str] = "fill in a table, marked cell by cell"
    KEYS: ClassVar[tuple[Key, ...]] = (
        Key("columns", "the heads of the columns", "[push, velocity after 2 s]",
            {"type": "array", "items": PROSE, "minItems": 2}, True),
        Key("rows", "a list for each row: texts, and cells to fill in",
            "[[0.1 N, {answer: 0.4 m/s, tolerance: 0.02 m/s}]]",
            {"type": "array", "minItems": 1, "items": {"type": "array", "items": {"anyOf": [
                NUMBER_OR_PROSE, {"type": "object", "required": ["answer", "tolerance"],
                 "properties": {key.name: key.schema for key in CELL_KEYS},
                 "additionalProperties": False}]}}}, True),
        Key("plot", "two columns, drawn as points against each other", "[push, velocity after 2 s]",
            {"type": "array", "items": PROSE, "minItems": 2, "maxItems": 2}),
    )  # fmt: skip
    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    plot: tuple[int, int] | None  # columns, from 0

    @classmethod
    def read(
        cls, table: Mapping[str, Any], common: Common, path: Path, problems: list[Problem]
    ) -> Self:
        """As many cells in each row as there are columns, and at least one to fill in."""
        before = len(problems)
        columns = keys.texts(table, "columns", path, problems, "columns: [push, velocity]")
        unread = len(problems) > before
        listed = table.get("rows")
        if not isinstance(listed, (list, tuple)) or not 1 <= len(listed) <= MOST:
            message = f"rows lists 1 to {MOST} rows"
            problems.append(Problem((*path, "rows"), "not-a-list", message, HINT))
            listed = ()
        if unread:
            listed = ()
        elif not 2 <= len(set(columns)) == len(columns) <= MOST:
            message = f"columns lists 2 to {MOST} different heads"
            problems.append(Problem((*path, "columns"), "not-a-list", message, "columns: [a, b]"))
            listed = ()
        rows = []
        for k, row in enumerate(listed):
            here = (*path, "rows", k)
            if not isinstance(row, (list, tuple)) or len(row) != len(columns):
                message = f"a row has {len(columns)} cells, as there are columns"
                problems.append(Problem(here, "wrong-count", message, HINT))
                continue
            rows.append(tuple(_cell(cell, (*here, c), problems) for c, cell in enumerate(row)))
        if len(problems) == before and not any(
            isinstance(cell, Open) for row in rows for cell in row
        ):
            message = "no cell is left to fill in"
            problems.append(Problem((*path, "rows"), "missing", message, HINT))
        plot = _plot(table, columns, rows, path, problems)
        return cls(common=common, columns=columns, rows=tuple(rows), plot=plot)

    @classmethod
    def from_key(cls, row: Mapping[str, Any], common: Common) -> Self:
        """Heads, given cells, and the interval of each other one; the page knows the units."""
        cells, asked = row["key"]["cells"], row["cells"]

        def cell(name: str, given: str | None) -> Cell:
            if given is not None:
                return given
            right = cells[name]
            unit = str(asked[name]["unit"])
            return Open(float(right["answer"]), float(right["tolerance"]), unit, {})

        rows = tuple(
            tuple(cell(f"{r}-{c}", given) for c, given in enumerate(line, start=1))
            for r, line in enumerate(row["rows"], start=1)
        )
        plot = (int(row["plot"][0]) - 1, int(row["plot"][1]) - 1) if row["plot"] else None
        return cls(common=common, columns=tuple(row["columns"]), rows=rows, plot=plot)

    @property
    def open(self) -> dict[str, Open]:
        """The cells to fill in, by `row-column`."""
        return {
            f"{r}-{c}": cell
            for r, row in enumerate(self.rows, start=1)
            for c, cell in enumerate(row, start=1)
            if isinstance(cell, Open)
        }

    def unit_of(self, column: int) -> str:
        """The unit of all numbers in a column, from 0; "" where there is none, or more than one."""
        cells = [row[column] for row in self.rows]
        units = {c.unit if isinstance(c, Open) else "".join(c.split(maxsplit=1)[1:]) for c in cells}
        return units.pop() if len(units) == 1 else ""

    def asked(self) -> dict[str, Any]:
        """Heads, given cells and the units of the others."""
        shape = [[None if isinstance(c, Open) else c for c in row] for row in self.rows]
        cells = {name: {"unit": c.unit, "units": dict(c.units)} for name, c in self.open.items()}
        given = {}
        if self.plot:
            given = {
                f"{r}-{c + 1}": _plain(cell)
                for r, row in enumerate(self.rows, start=1)
                for c, cell in enumerate(row)
                if c in self.plot and isinstance(cell, str)
            }
        plot = [c + 1 for c in self.plot] if self.plot else None
        return {
            "columns": list(self.columns), "rows": shape, "cells": cells,
            "plot": plot, "given": given,
        }  # fmt: skip

    def key(self) -> dict[str, Any]:
        """The interval of each open cell."""
        cells = {
            name: {"answer": cell.answer, "tolerance": cell.tolerance}
            for name, cell in self.open.items()
        }
        return {"cells": cells, "feedback": []}

    def meaning(self) -> dict[str, Any]:
        """Heads, given cells and units."""
        cells = {name: cell.unit for name, cell in self.open.items()}
        return {"columns": self.columns, "rows": self.asked()["rows"], "cells": cells}

    def mark(self, value: object, own: float | None = None) -> Mark:
        """`shown` names the cells that are right: `cell-1-2`."""
        del own
        of = self.common.marks
        if is_empty(value):
            return Mark("empty", 0, of)
        cells = self.open
        if not isinstance(value, Mapping) or not set(value) <= set(cells):
            return Mark("unclear", 0, of)
        good = [
            name
            for name, cell in cells.items()
            if mark_number(value.get(name), cell.answer, cell.tolerance, 1).verdict == "right"
        ]
        shown = tuple(f"cell-{name}" for name in good)
        return all_or_nothing(len(good) == len(cells), bool(good), of, shown=shown)


def _cell(cell: object, path: Path, problems: list[Problem]) -> Cell:
    if not isinstance(cell, Mapping):
        if isinstance(cell, bool) or not isinstance(cell, (str, int, float)):
            problems.append(Problem(path, "not-text", "a given cell is a text or a number", HINT))
        return str(cell)
    before = len(problems)
    elsewhere = {"value": meant("answer")}
    unknown_keys(cell, keys.names(CELL_KEYS), path, problems, elsewhere=elsewhere)
    measured = read_unit(cell, "answer", path, problems)
    if len(problems) > before:  # whatever is said about the rest would follow from this
        return Open(answer=0, tolerance=0, unit="", units={})
    return Open(**as_asked(read_right(cell, measured, path, problems), measured))


def _plain(text: str) -> float | None:
    """The number that a given cell begins with."""
    try:
        return float(text.split(maxsplit=1)[0].replace("−", "-"))
    except (ValueError, IndexError):
        return None


def _plot(
    table: Mapping[str, Any],
    columns: tuple[str, ...],
    rows: list[tuple[Cell, ...]],
    path: Path,
    problems: list[Problem],
) -> tuple[int, int] | None:
    if "plot" not in table:
        return None
    heads = keys.texts(table, "plot", path, problems, f"plot: [{', '.join(columns[:2])}]")
    if len(heads) != 2 or len(set(heads) & set(columns)) != 2:
        message = "plot names two of the columns"
        hint = f"plot: [{', '.join(columns[:2])}]"
        problems.append(Problem((*path, "plot"), "not-a-choice", message, hint))
        return None
    first, second = (columns.index(head) for head in heads)
    for r, row in enumerate(rows):
        for c in (first, second):
            cell = row[c]
            if isinstance(cell, str) and _plain(cell) is None:
                message = f"“{cell[:30]}” is no number: it cannot be drawn"
                problems.append(Problem((*path, "rows", r, c), "not-a-number", message, "0.1 N"))
    return first, second
