"""Where a report of `carts class` goes: to the terminal and into the files that were asked for."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

from sim.classroom.report.class_csv import items_csv, students_csv
from sim.classroom.show.standalone import standalone
from sim.classroom.summary.sums import LessonSums
from sim.cli.classroom.summary import write_summary
from sim.cli.classroom.text import report_as_text


@dataclass(frozen=True, slots=True)
class Out:
    """What was asked for."""

    ctx: click.Context
    as_json: bool
    html: Path | None
    csv_file: Path | None
    items_file: Path | None
    summary: Path | None
    by_total: bool

    def sums(self, lessons: Sequence[LessonSums], groups: Sequence[str]) -> None:
        """Writes the sums that may be handed on, where that was asked for."""
        if self.summary:
            write_summary(self.summary, lessons, groups, by_total=self.by_total)

    def report(
        self, report: dict[str, Any], refused: Sequence[tuple[str, str]], *, anything: bool
    ) -> None:
        """Hands out a report; exit code 1 where something was refused, or nothing was found."""
        self._hand(report)
        for name, reason in refused:
            click.echo(f"{name}: {reason}", err=True)
        if refused or not anything:
            self.ctx.exit(1)

    def _hand(self, report: dict[str, Any]) -> None:
        """Writes the files of a report, and prints it."""
        if self.html:
            self.html.write_text(standalone(report), encoding="utf-8")
        if self.csv_file:
            self.csv_file.write_text(students_csv(report), encoding="utf-8", newline="")
        if self.items_file:
            self.items_file.write_text(items_csv(report), encoding="utf-8", newline="")
        if self.as_json:
            click.echo(json.dumps(report, ensure_ascii=False, allow_nan=False))
            return
        click.echo(report_as_text(report))
        for path in filter(None, (self.html, self.csv_file, self.items_file)):
            click.echo(f"Written: {path}")
