"""A table with one row for each answer, made wide: a row for each student and test."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sim.classroom.tables.cells import MOST_COLUMNS, TableRow
from sim.classroom.tables.layout import Column, Layout
from sim.scene.said import said, template

Bad = tuple[int, str]


def pivoted(
    layout: Layout, heads: TableRow, rows: Sequence[TableRow]
) -> tuple[Layout, TableRow, list[TableRow], list[Bad]]:
    """Layout, headings, rows and bad lines of the wide table; rows bear their first line.

    Columns: student, group, class, time, then the items in their order.
    """
    (column,) = layout.items
    person = layout.student[0] if layout.student else ()
    fixed = (layout.group, layout.klass, layout.time)
    made: dict[tuple[str, ...], dict[str, str]] = {}
    lines: dict[tuple[str, ...], int] = {}
    names: dict[str, int] = {}
    bad: list[Bad] = []
    for row in rows:
        who = " ".join(filter(None, (row.cell(k) for k in person)))
        cells = (who, *(row.cell(k) for k in fixed))
        name = row.cell(layout.item)
        mark = row.cell(column.place)
        answers = made.setdefault(cells, {})
        lines.setdefault(cells, row.line)
        if not name:
            bad.append((row.line, template("no item is named")))
        elif name in answers:
            bad.append((row.line, said("this student has an answer to “{item}” already",
                                       item=name[:24])))  # fmt: skip
        elif len(names) >= MOST_COLUMNS and name not in names:
            bad.append((row.line, said("more than {most} items", most=f"{MOST_COLUMNS:,}")))
        else:
            names.setdefault(name, 4 + len(names))
            answers[name] = mark
    wide = [
        TableRow(lines[cells], (*cells, *(answers.get(name, "") for name in names)))
        for cells, answers in made.items()
    ]
    places = [k if place is not None else None for k, place in enumerate(fixed, 1)]
    return (
        replace(
            layout, item=None, student=((0,),) if person else (),
            group=places[0], klass=places[1], time=places[2],
            items=tuple(Column(k, name, "", column.of) for name, k in names.items()),
        ),
        TableRow(heads.line, ("", "", "", "", *names)),
        wide,
        bad,
    )  # fmt: skip
