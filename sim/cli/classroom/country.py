"""`carts class --parquet` and `--table DIR`: answers as a table, and the report from such a table.

The packages of the extra `country` are imported here, inside functions, and nowhere before.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import wraps
from pathlib import Path
from typing import Any, ParamSpec, TypeVar

import click

from sim.classroom.files.keyed import KeyedForm, KeyFileError, read_key_file
from sim.classroom.report.report import WHOLE
from sim.classroom.summary.sums import LessonSums
from sim.cli.classroom.calls import Given
from sim.cli.classroom.files import group_of, sources
from sim.country.backend import DUCKDB, answers_in, connect, is_parquet
from sim.country.from_files import Written, write_table
from sim.country.refusal import MISSING, PACKAGES, CountryError
from sim.country.report import read_table
from sim.scene.said import said

P = ParamSpec("P")
R = TypeVar("R")
Found = tuple[dict[str, Any], list[LessonSums], tuple[str, ...]]


def _with_the_extra(made: Callable[P, R]) -> Callable[P, R]:
    """Says in a sentence what is missing, and what is wrong with a table."""

    @wraps(made)
    def called(*args: P.args, **more: P.kwargs) -> R:
        try:
            return made(*args, **more)
        except ModuleNotFoundError as error:
            name = (error.name or "").split(".")[0]
            if name not in PACKAGES:
                raise
            raise click.UsageError(f"{MISSING} (there is no {name})") from None
        except CountryError as error:
            raise click.ClickException(str(error)) from None

    return called


def of_country(tables: Sequence[str], backend: str | None) -> bool:
    """Whether these are tables of answers and no tables of marks; both at once cannot be."""
    found = [backend is not None or is_parquet(text) for text in tables]
    if any(found) and not all(found):
        raise click.UsageError("--table: tables of answers and tables of marks do not mix")
    return any(found)


@_with_the_extra
def write_answers(folder: Path, given: Given, say: Callable[[str], None]) -> Written:
    """Writes the table; says how much stands in it."""
    names = list(dict.fromkeys(name for name, _ in given.groups))

    def place(name: str) -> tuple[str, int, str]:
        if not given.groups:
            return WHOLE, 1, ""
        found = next(((g, p) for g, p in given.groups if group_of(name, [(g, p)])), ("", ""))
        return found[0], names.index(found[0]) + 1 if found[0] else 0, found[1]

    done = write_table(folder, lambda: sources(given.files), place, students=given.students,
                       codes=given.codes)  # fmt: skip
    say(said("{folder}: {rows} rows of {files} files", folder=str(folder), rows=f"{done.rows:,}",
             files=f"{done.files:,}"))  # fmt: skip
    return done


@_with_the_extra
def country_report(tables: Sequence[str], backend: str | None, keys: Sequence[Path]) -> Found:
    """The report, its sums and its groups."""
    for text in tables:
        if is_parquet(text) and not Path(text).exists():
            raise click.UsageError(f"--table {text}: there is no such file")
    answers = answers_in(connect(backend or DUCKDB), tables)
    return read_table(answers, _keys([*_beside(tables), *keys]))


def to_hand_on(lessons: Sequence[LessonSums]) -> list[LessonSums]:
    """The sums without questions that nobody marked: what stands in them may have been typed."""
    return [
        replace(lesson, forms={
            name: form if form.has_key else replace(form, items=(), groups={
                group: replace(sums, items={}) for group, sums in form.groups.items()
            })
            for name, form in lesson.forms.items()
        })
        for lesson in lessons
    ]  # fmt: skip


def _beside(tables: Sequence[str]) -> list[Path]:
    """Keys that lie in the folder of a table."""
    folders = [Path(text) if Path(text).is_dir() else Path(text).parent
               for text in tables if is_parquet(text)]  # fmt: skip
    return [path for folder in folders for path in sorted(folder.glob("key-*.json"))]


def _keys(paths: Sequence[Path]) -> list[KeyedForm]:
    keys: list[KeyedForm] = []
    for path in paths:
        try:
            keys += read_key_file(path.read_text(encoding="utf-8-sig"))
        except (KeyFileError, OSError, UnicodeDecodeError) as error:
            raise CountryError(f"{path}: {error}") from None
    return keys
