"""`carts class`: what a class answered and learned, from the students' answer files."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import click

from sim.classroom.files.codes import read_codes
from sim.classroom.files.reading import Read, Reading, Refused, outcomes
from sim.classroom.report.class_csv import items_csv, students_csv
from sim.classroom.report.report import WHOLE, Asked, class_report
from sim.classroom.show.standalone import standalone
from sim.classroom.tables.report import table_report
from sim.cli.classroom.files import group_of, sources
from sim.cli.classroom.summary import lessons_of_answers, merged_report, write_summary, write_whole
from sim.cli.classroom.tables import tables_of
from sim.cli.classroom.text import report_as_text

FILE = click.Path(dir_okay=False, path_type=Path)
EXISTING = click.Path(exists=True, dir_okay=False, path_type=Path)


@click.command("class")
@click.argument("files", nargs=-1, type=click.Path(exists=True, path_type=Path))
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, for programs.")
@click.option("--html", type=FILE, help="Write the report as one HTML file, to keep and to print.")
@click.option("--csv", "csv_file", type=FILE, help="Write marks by student as a table.")
@click.option("--items", "items_file", type=FILE, help="Write numbers by question as a table.")
@click.option("--key", "keys", type=EXISTING, multiple=True, help="Key file of `carts key`.")
@click.option("--marks", type=EXISTING, help="Your marks for answers in words, a file of the page.")
@click.option("--codes", type=EXISTING, help="Typed hand-in codes, a line each: WORD FORM CODE.")
@click.option(
    "--group",
    "groups",
    multiple=True,
    metavar="NAME=GLOB",
    help="Put files into a group; the same name again is another class of it. With two groups "
    "the first is compared with the second.",
)
@click.option(
    "--student",
    "students",
    multiple=True,
    metavar="FILE=CODE",
    help="The code word of a file that has none.",
)
@click.option(
    "--table",
    "tables",
    multiple=True,
    metavar="[TIME=]FILE",
    help="Read marks from a table (CSV) in place of answer files; TIME: pre, post or later.",
)
@click.option("--max", "most", metavar="N", help="The most marks of totals in a table.")
@click.option("--lesson", metavar="NAME", help="The name of the lesson of a table.")
@click.option(
    "--summary",
    type=FILE,
    help="Write sums by group and question to hand on: no answer "
    "and no total of a student, no group of fewer than 5.",
)
@click.option(
    "--by-total",
    is_flag=True,
    help="With --summary: also the marks by total. Where one "
    "student alone has a total, these are that student's answers.",
)
@click.option("--merge", is_flag=True, help="FILES are summaries: add them and report on the sum.")
@click.pass_context
def command(
    ctx: click.Context,
    files: tuple[Path, ...],
    as_json: bool,
    html: Path | None,
    csv_file: Path | None,
    items_file: Path | None,
    keys: tuple[Path, ...],
    marks: Path | None,
    codes: Path | None,
    groups: tuple[str, ...],
    students: tuple[str, ...],
    tables: tuple[str, ...],
    most: str | None,
    lesson: str | None,
    summary: Path | None,
    by_total: bool,
    merge: bool,
) -> None:
    """Say what a class answered and learned, from its answer files.

    FILES are answer files, folders with answer files in them, zips, and key files. A file that
    cannot be used is named on standard error with the reason; the others are analysed. Nothing is
    sent anywhere.

    \b
    carts class answers/ --html report.html
    carts class answers.zip build/keys/
    carts class answers/ --group "new=7a-*" --group "old=7b-*"
    carts class --table marks.csv --html report.html
    carts class --table pre=quiz-1.csv --table post=quiz-2.csv
    carts class answers/ --key KEY.json --summary school-a.json
    carts class --merge school-a.json school-b.json
    """
    named = [_group(text) for text in groups]
    of_answers = (*keys, *students, *filter(None, (marks, codes)))
    _only_one_way(ctx, files, tables, of_answers, [*filter(None, (most, lesson))], merge=merge)
    if by_total and (not summary or merge):
        raise click.UsageError("--by-total belongs to --summary")
    if merge:
        report, whole, left_out = merged_report(files)
        if summary:
            write_whole(summary, whole)
        _hand_out(report, as_json, html, csv_file, items_file)
        _end(ctx, left_out, anything=bool(whole.lessons))
        return
    if tables:
        found, unread = tables_of(tables, named, most, lesson)
        report = table_report(found)
        if summary:
            write_summary(summary, [found.lesson], found.groups, by_total=by_total)
        _hand_out(report, as_json, html, csv_file, items_file)
        _end(ctx, [*unread, *found.refused], anything=bool(found.taken))
        return
    reading = Reading.of([])
    given = [*files, *keys, *([marks] if marks else [])]
    for outcome in outcomes(sources(given)):
        reading.add(outcome)
    if codes:
        typed, bad = read_codes(codes.read_text(encoding="utf-8-sig"), reading.keys)
        reading.files += typed
        reading.refused += bad
    reading.name(dict(_student(text) for text in students))
    sorted_ = _sorted(reading, named)
    asked = _asked(reading, named)
    report = class_report(*sorted_, asked)
    if summary:
        lessons = lessons_of_answers(sorted_[0], reading.keys, asked)
        write_summary(summary, lessons, asked.groups, by_total=by_total)
    _hand_out(report, as_json, html, csv_file, items_file)
    _end(ctx, [(r.name, r.reason) for r in reading.refused], anything=bool(reading.files))


def _only_one_way(
    ctx: click.Context,
    files: Sequence[Path],
    tables: Sequence[str],
    of_answers: Sequence[object],
    of_tables: Sequence[object],
    *,
    merge: bool,
) -> None:
    """Answer files, tables or summaries, and to each the options that are made for it."""
    if not files and not tables:
        raise click.MissingParameter(ctx=ctx, param=ctx.command.params[0])
    if tables and (files or of_answers):
        raise click.UsageError("--table reads tables only: no answer files, keys, codes and marks")
    if of_tables and not tables:
        raise click.UsageError("--max and --lesson belong to --table")
    if merge and (tables or of_answers):
        raise click.UsageError("--merge adds summaries only: no tables, keys, codes and marks")


def _hand_out(
    report: dict[str, Any],
    as_json: bool,
    html: Path | None,
    csv_file: Path | None,
    items_file: Path | None,
) -> None:
    """Writes the files that were asked for, and prints the report."""
    if html:
        html.write_text(standalone(report), encoding="utf-8")
    if csv_file:
        csv_file.write_text(students_csv(report), encoding="utf-8", newline="")
    if items_file:
        items_file.write_text(items_csv(report), encoding="utf-8", newline="")
    if as_json:
        click.echo(json.dumps(report, ensure_ascii=False, allow_nan=False))
    else:
        click.echo(report_as_text(report))
        for path in filter(None, (html, csv_file, items_file)):
            click.echo(f"Written: {path}")


def _end(ctx: click.Context, refused: Sequence[tuple[str, str]], *, anything: bool) -> None:
    """Names what was refused; exit code 1 where something was, or nothing was found."""
    for name, reason in refused:
        click.echo(f"{name}: {reason}", err=True)
    if refused or not anything:
        ctx.exit(1)


def _student(text: str) -> tuple[str, str]:
    name, equals, code = text.rpartition("=")
    if not (name.strip() and equals and code.strip()):
        raise click.UsageError(f"--student {text}: write FILE=CODE, for example a.json=BLUE-FOX-27")
    return name.strip(), code.strip()


def _group(text: str) -> tuple[str, str]:
    name, equals, pattern = text.partition("=")
    if not (name.strip() and equals and pattern):
        raise click.UsageError(f"--group {text}: write NAME=GLOB, for example new='class-7a/*'")
    return name.strip(), pattern


def _sorted(
    reading: Reading, groups: list[tuple[str, str]]
) -> tuple[list[tuple[Read, str]], Any, list[Refused]]:
    """Files with their groups; what is in no group is refused in words."""
    if not groups:
        return [(file, WHOLE) for file in reading.files], reading.keys, reading.refused
    placed = [(file, group_of(file.name, groups)) for file in reading.files]
    reading.refused += [
        Refused(file.name, "this file is in none of the groups")
        for file, group in placed
        if not group
    ]
    return [(f, group) for f, group in placed if group], reading.keys, reading.refused


def _asked(reading: Reading, groups: list[tuple[str, str]]) -> Asked:
    """Each pattern that has files is a class of its own."""
    names = tuple(dict.fromkeys(name for name, _ in groups)) or (WHOLE,)
    patterns = {
        (name, pattern)
        for name, pattern in groups
        if any(group_of(file.name, [(name, pattern)]) for file in reading.files)
    }
    classes = Counter(name for name, _ in patterns)
    now = datetime.now(UTC).isoformat(timespec="seconds")
    return Asked(groups=names, classes=classes, given=reading.given, now=now)
