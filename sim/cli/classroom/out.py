"""Where a report of `carts class` goes: to the terminal and into the files that were asked for."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from sim.classroom.show.class_csv import items_csv, students_csv
from sim.classroom.show.standalone import standalone
from sim.classroom.summary.sums import LessonSums
from sim.cli.classroom.spreadsheet import parted_by
from sim.cli.classroom.summary import write_summary
from sim.cli.classroom.text import report_as_text, teller
from sim.cli.write_out import write_out
from sim.pages.language import words
from sim.scene.said import said


@dataclass(frozen=True, slots=True)
class Out:
    """What was asked for, and the language that it is told in."""

    ctx: click.Context
    as_json: bool
    html: Path | None
    csv_file: Path | None
    items_file: Path | None
    summary: Path | None
    by_total: bool
    language: str
    separator: str

    @property
    def words(self) -> Mapping[str, str]:
        """What each English sentence is in the language."""
        return words(self.language)

    def say(self, sentence: str, *, err: bool = False) -> None:
        """Prints a sentence of ours."""
        click.echo(teller(self.words)(sentence), err=err)

    def sums(self, lessons: Sequence[LessonSums], groups: Sequence[str]) -> None:
        """Writes the sums that may be handed on, where that was asked for."""
        if self.summary:
            for left_out in write_summary(self.summary, lessons, groups, by_total=self.by_total):
                self.say(left_out, err=True)

    def report(
        self, report: dict[str, Any], refused: Sequence[tuple[str, str]], *, anything: bool
    ) -> None:
        """Hands out a report; exit code 1 where something was refused, or nothing was found."""
        self._hand(report)
        for name, reason in refused:
            self.say(said("{name}: {reason}", name=name, reason=reason), err=True)
        if refused or not anything:
            self.ctx.exit(1)

    def _hand(self, report: dict[str, Any]) -> None:
        """Writes the files of a report, and prints it. JSON is for programs and stays English."""
        if self.html:
            write_out(self.html, standalone([report], self.words, self.language), "--html FILE")
        if self.csv_file:
            table = parted_by(self.separator, students_csv(report, self.words))
            write_out(self.csv_file, table, "--csv FILE")
        if self.items_file:
            table = parted_by(self.separator, items_csv(report, self.words))
            write_out(self.items_file, table, "--items FILE")
        if self.as_json:
            click.echo(json.dumps(report, ensure_ascii=False, allow_nan=False))
            return
        click.echo(report_as_text(report, self.words))
        for path in filter(None, (self.html, self.csv_file, self.items_file)):
            self.say(written(path))


def written(path: Path) -> str:
    """That a file is there now."""
    return said("Written: {file}", file=str(path))
