"""The options of `carts class` as one value, and what each part of it takes from them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import click

from sim.cli.classroom.calls import Given, group, student
from sim.cli.classroom.out import Out
from sim.cli.classroom.papers import Papers
from sim.cli.classroom.spreadsheet import COMMA


@dataclass(frozen=True, slots=True, kw_only=True)
class Options:
    """As click hands them over; what each one means stands beside it in `results`."""

    as_json: bool
    html: Path | None
    slips: Path | None
    sheet: Path | None
    language: str
    answers: bool
    csv_file: Path | None
    items_file: Path | None
    separator: str | None
    keys: tuple[Path, ...]
    marks: Path | None
    codes: tuple[Path, ...]
    groups: tuple[str, ...]
    students: tuple[str, ...]
    tables: tuple[str, ...]
    most: str | None
    lesson: str | None
    summary: Path | None
    by_total: bool
    merge: bool
    parquet: Path | None
    backend: str | None

    def out(self, ctx: click.Context) -> Out:
        """Where the report goes."""
        return Out(
            ctx, self.as_json, self.html, self.csv_file, self.items_file, self.summary,
            self.by_total, self.language, self.separator or COMMA,
        )  # fmt: skip

    def given(self, files: tuple[Path, ...]) -> Given:
        """The answer files, and what belongs to them."""
        marked = [*files, *self.keys, *([self.marks] if self.marks else [])]
        groups, students = list(map(group, self.groups)), dict(map(student, self.students))
        return Given(marked, groups, students, list(map(_typed, self.codes)))

    @property
    def papers(self) -> Papers:
        """Slips and the sheet."""
        return Papers(self.slips, self.sheet, self.answers)


def _typed(path: Path) -> tuple[str, str]:
    """A file of typed codes as it is called, and its text."""
    try:
        return path.as_posix(), path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise click.UsageError(f"--codes {path}: save this file as UTF-8") from None
