"""`carts class --summary` and `--merge`: sums that leave a school, and those of many added."""

from __future__ import annotations

import gc
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from sim.classroom.files.reading import Read as ReadFile
from sim.classroom.report.marked import Keys
from sim.classroom.report.report import Asked, sorted_files
from sim.classroom.summary.document import Read, document
from sim.classroom.summary.handed_on import Summary, handed_on
from sim.classroom.summary.merge import merged
from sim.classroom.summary.numbers import SummaryError
from sim.classroom.summary.of_answers import lessons_of
from sim.classroom.summary.once import Named, once
from sim.classroom.summary.reading import MOST_BYTES, read_summary
from sim.classroom.summary.sums import LessonSums
from sim.classroom.summary.written import summary_file
from sim.cli.write_out import write_out
from sim.scene.said import counted, reason_of


def write_summary(
    path: Path, lessons: Sequence[LessonSums], groups: Sequence[str], *, by_total: bool
) -> list[str]:
    """Writes what may be handed on; gives sentences on what was left out of it."""
    summary = handed_on(lessons, groups, by_total=by_total)
    write_whole(path, summary)
    file = str(path)
    says: list[str] = []
    if summary.withheld:
        says.append(counted(
            "{file}: 1 group is too small and withheld (fewer than 5 students)",
            "{file}: {n} groups are too small and withheld (fewer than 5 students)",
            n=summary.withheld, file=file,
        ))  # fmt: skip
    if summary.of_small_classes:
        says.append(counted(
            "{file}: 1 student with both tests is in no gain: fewer than 5 of the class have both",
            "{file}: {n} students with both tests are in no gain: fewer than 5 of their class have "
            "both",
            n=summary.of_small_classes, file=file,
        ))  # fmt: skip
    if summary.of_no_class:
        says.append(counted(
            "{file}: 1 student with both tests is in no gain: no class is given, while others have "
            "one",
            "{file}: {n} students with both tests are in no gain: no class is given, while others "
            "have one",
            n=summary.of_no_class, file=file,
        ))  # fmt: skip
    return says


def write_whole(path: Path, summary: Summary) -> None:
    """Writes a summary as it is."""
    text = json.dumps(summary_file(summary), ensure_ascii=False, allow_nan=False)
    write_out(path, f"{text}\n", "--summary FILE")


def lessons_of_answers(
    files: Sequence[tuple[ReadFile, str]], keys: Sequence[Any], asked: Asked
) -> list[LessonSums]:
    """The sums of the files that the report counts."""
    of_files = Keys(keys)
    counted = sorted_files(files, of_files, asked).counted
    return lessons_of(counted, of_files.main, asked.groups, asked.classes)


def merged_report(
    paths: Sequence[Path],
) -> tuple[dict[str, Any], Summary, list[tuple[str, str]]]:
    """The report on all summaries, their sum, and what was refused."""
    gc.disable()  # a million small numbers, none in a circle: looking for circles takes 4 of 10 s
    try:
        named, refused = _read(paths)
        named, doubled, notes = once(named)
        summary, left_out = merged(named)
    finally:
        gc.enable()
    refused = sorted([*refused, *doubled, *left_out])
    read = Read(unit="summaries", read=len(paths), counted=len(named), refused=refused, notes=notes)
    return document(summary.lessons, summary.groups, read), summary, refused


def _read(paths: Sequence[Path]) -> tuple[list[Named], list[tuple[str, str]]]:
    named: list[Named] = []
    refused: list[tuple[str, str]] = []
    for path in paths:
        try:
            with path.open("rb") as file:
                named.append((path.as_posix(), read_summary(file.read(MOST_BYTES + 1))))
        except SummaryError as error:
            refused.append((path.as_posix(), reason_of(error)))
        except OSError as error:
            refused.append((path.as_posix(), str(error.strerror)))
    return named, refused
