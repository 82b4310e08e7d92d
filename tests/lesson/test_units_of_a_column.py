"""The head of a column names a unit only where all its numbers are in it; a plot names columns."""

from __future__ import annotations

from typing import Any

import pytest

from sim.lesson.kinds.table import Table
from sim.lesson.read import read_question


def asked(answer: str, tolerance: str) -> dict[str, Any]:
    return {"answer": answer, "tolerance": tolerance}


TIME, SPEED = asked("2 s", "0.1 s"), asked("0.8 m/s", "0.02 m/s")


@pytest.mark.parametrize(
    ("column", "unit"),
    [
        ([SPEED, SPEED], "m/s"),
        ([SPEED, "0.4 m/s"], "m/s"),
        (["0.1 N", "0.2 N"], "N"),
        (["0.1 N", "0.2 mN"], ""),
        ([SPEED, TIME], ""),
        ([SPEED, "0.4"], ""),
        (["1", "2"], ""),
    ],
)
def test_a_column_has_a_unit_where_all_its_cells_have_that_one(
    column: list[Any], unit: str
) -> None:
    rows = [[cell, TIME] for cell in column]
    table = read_question(
        {"id": "t", "type": "table", "ask": "?", "columns": ["what", "time"], "rows": rows}
    )
    assert isinstance(table, Table)
    assert (table.unit_of(0), table.unit_of(1)) == (unit, "s")


@pytest.mark.parametrize("plot", [["push", "time"], ["time", "push"]])
def test_a_plot_has_its_axes_in_the_order_in_which_it_names_the_columns(plot: list[str]) -> None:
    columns = ["push", "what", "time"]
    table: dict[str, Any] = {"id": "t", "type": "table", "ask": "?", "columns": columns}
    facts = read_question({**table, "rows": [["0.1 N", "x", TIME]], "plot": plot}).data(key=True)
    assert [columns[place - 1] for place in facts["plot"]] == plot
