"""`carts class --slips` and `--sheet`: what a class gets back on paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.files.reading import Read
from sim.classroom.handouts.paper import Handout, handout, handout_file
from sim.classroom.report.report import Asked
from sim.cli.classroom.out import Out, written
from sim.cli.write_out import write_out


@dataclass(frozen=True, slots=True)
class Papers:
    """Where the slips and the sheet go, with or without right answers."""

    slips: Path | None
    sheet: Path | None
    answers: bool

    def write(
        self, out: Out, files: Sequence[tuple[Read, str]], keys: Sequence[KeyedForm], asked: Asked
    ) -> None:
        """Writes what was asked for, in the language of the report."""
        for what, path in (("slips", self.slips), ("sheet", self.sheet)):
            if path is None:
                continue
            wanted = Handout(
                what=what, language=out.language, words=out.words, answers=self.answers
            )
            html = handout(files, keys, asked, wanted)
            write_out(path, handout_file(html, wanted), f"--{what} FILE")
            out.say(written(path), err=True)
