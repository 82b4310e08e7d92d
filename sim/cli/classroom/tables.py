"""Tables of anybody's marks for `carts class --table`: which files, which test, which group."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from sim.classroom.report.report import WHOLE
from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.cells import MOST_BYTES, TableError
from sim.classroom.tables.distinct import distinct
from sim.classroom.tables.layout import form_of
from sim.classroom.tables.marks import most_of
from sim.classroom.tables.read import read_table
from sim.classroom.tables.report import Judged, judge
from sim.classroom.tables.taken import TOTALS_ONLY, MarkTable, Taken
from sim.cli.classroom.calls import warn_of_empty
from sim.cli.classroom.files import group_of
from sim.scene.said import reason_of


def tables_of(
    given: Sequence[str], groups: list[tuple[str, str]], most: str | None, lesson: str | None
) -> tuple[Judged, list[tuple[str, str]]]:
    """The tables as one lesson, called `lesson` or as the first; and files that are no tables."""
    tables: list[MarkTable] = []
    bad: list[tuple[str, str]] = []
    places = [_place(text) for text in given]
    paths = [path.as_posix() for _, path in places]
    names = dict(zip(distinct(paths), paths, strict=True))
    for name, (form, path) in zip(names, places, strict=True):
        lesson = lesson or path.stem
        try:
            with path.open("rb") as file:
                tables.append(read_table(name, file.read(MOST_BYTES + 1), form))
        except TableError as error:
            bad.append((path.as_posix(), reason_of(error)))
        except OSError as error:
            bad.append((path.as_posix(), str(error.strerror)))
    told = _most(most)
    if told is not None and any(table.of_items for table in tables):
        raise click.UsageError(f"--max {TOTALS_ONLY}")

    if groups and any(table.groups for table in tables):
        raise click.UsageError("--group: a table has a column of groups already")
    warn_of_empty(groups, list(names.values()))
    totals = [row for table in tables for row in table.taken if row.total is not None]
    if told is not None and totals and all(row.of is not None for row in totals):
        click.echo(f"warning: --max {most} changes nothing: the table tells it", err=True)

    def group(row: Taken) -> str:
        return group_of(names[row.table], groups) if groups else WHOLE

    return judge(lesson or "", tables, group, most=told), bad


def _place(text: str) -> tuple[str, Path]:
    """`pre=quiz-1.csv` is a table of the test before; a file of that very name comes first."""
    before, equals, after = text.partition("=")
    if equals and form_of(before) and not Path(text).exists():
        form, path = form_of(before), Path(after)
    else:
        form, path = "", Path(text)
    if not path.is_file():
        raise click.UsageError(f"--table {text}: there is no such file")
    return form, path


def _most(text: str | None) -> Exact | None:
    if text is None:
        return None
    try:
        return most_of(text)
    except TableError as error:
        raise click.UsageError(f"--max {text}: {error}") from None
