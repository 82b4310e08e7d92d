"""`carts class`: what a class answered and learned, from the students' answer files."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import click

from sim.classroom.files.codes import read_codes
from sim.classroom.files.reading import Reading, outcomes
from sim.classroom.report.report import class_report
from sim.classroom.tables.report import table_report
from sim.cli.classroom.calls import (
    Given,
    asked,
    known,
    no_answers_as_keys,
    only_country,
    only_one_way,
    placed,
    warn_of_empty,
)
from sim.cli.classroom.country import country_report, of_country, to_hand_on, write_answers
from sim.cli.classroom.files import sources, tables_in
from sim.cli.classroom.options import Options
from sim.cli.classroom.out import Out
from sim.cli.classroom.papers import Papers
from sim.cli.classroom.spreadsheet import COMMA, SEMICOLON
from sim.cli.classroom.summary import lessons_of_answers, merged_report, write_whole
from sim.cli.classroom.tables import tables_of
from sim.cli.named_file import GivenFile
from sim.pages.language import ENGLISH, LANGUAGES
from sim.scene.said import said

FILE = click.Path(dir_okay=False, path_type=Path)
EXISTING = click.Path(exists=True, dir_okay=False, path_type=Path)


@click.command("class")
@click.argument("files", nargs=-1, type=GivenFile("a file of answers", folders=True))
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, for programs.")
@click.option("--html", type=FILE, help="Write the report as one HTML file, to keep and to print.")
@click.option("--slips", type=FILE, help="Write a feedback slip for each student, to be printed.")
@click.option("--sheet", type=FILE, help="Write a page of the class, without names, to be printed.")
@click.option(
    "--language",
    type=click.Choice(list(LANGUAGES)),
    default=ENGLISH,
    help="What the report speaks, and --html, --csv, --items, --slips and --sheet.",
)
@click.option("--answers", is_flag=True, help="Slips with the right answers.")
@click.option("--csv", "csv_file", type=FILE, help="Write marks by student as a table.")
@click.option("--items", "items_file", type=FILE, help="Write numbers by question as a table.")
@click.option(
    "--separator",
    type=click.Choice([COMMA, SEMICOLON]),
    help='Between cells of --csv and --items: "," (as without it), or ";" with decimal commas, for '
    "a spreadsheet that writes 0,5.",
)
@click.option("--key", "keys", type=EXISTING, multiple=True, help="Key file of `carts key`.")
@click.option("--marks", type=EXISTING, help="Your marks for answers in words, a file of the page.")
@click.option(
    "--codes",
    type=EXISTING,
    multiple=True,
    help="Typed hand-in codes, a line each: WORD FORM CODE. With --group they are in the group "
    "whose GLOB this file fits, else where their student's other files are.",
)
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
    help="Read marks from a table (CSV) in place of answer files; TIME: pre, post or later. Or "
    "answers from a table of --parquet: its folder, a Parquet file.",
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
@click.option(
    "--parquet",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="DIR",
    help="Write all answers as a table (Parquet) into this new folder, and report on it. For more "
    "files than one report can list.",
)
@click.option(
    "--backend",
    metavar="ADDRESS",
    help="With --table: who works on a table of answers; duckdb://FILE, spark://local, or another "
    "that Ibis knows.",
)
@click.pass_context
def command(ctx: click.Context, /, files: tuple[Path, ...], **options: Any) -> None:
    """Say what a class answered and learned, from its answer files.

    FILES are answer files, folders with answer files in them, zips, and key files. A file that
    cannot be used is named on standard error with the reason; the others are analysed. Nothing is
    sent anywhere.

    \b
    carts class answers/ --html report.html
    carts class answers/ --key KEY.json --slips slips.html --sheet sheet.html
    carts class answers/ --key KEY.json --html laporan.html --language ms
    carts class answers.zip build/keys/
    carts class answers/ --group "new=7a/*" --group "old=7b/*"
    carts class --table marks.csv --html report.html
    carts class --table pre=quiz-1.csv --table post=quiz-2.csv
    carts class answers/ --key KEY.json --summary school-a.json
    carts class --merge school-a.json school-b.json
    carts class answers/ --parquet country/
    carts class --table country/ --html country.html
    """
    wanted = Options(**options)
    out, given = wanted.out(ctx), wanted.given(files)
    if wanted.by_total and (not wanted.summary or wanted.merge):
        raise click.UsageError("--by-total belongs to --summary")
    if wanted.answers and not wanted.slips:
        raise click.UsageError("--answers belongs to --slips")
    if wanted.separator and not (wanted.csv_file or wanted.items_file):
        raise click.UsageError("--separator belongs to --csv and --items")
    if wanted.parquet or (wanted.tables and of_country(wanted.tables, wanted.backend)):
        only_country(ctx, wanted.parquet, wanted.tables)
        if wanted.parquet:
            _written(out, wanted.parquet, given)
        else:
            _country(out, wanted.tables, wanted.backend, wanted.keys, [])
        return
    only_one_way(ctx, files, wanted.tables)
    if wanted.merge:
        _merged(out, files, wanted.summary)
    elif wanted.tables:
        _tables(out, wanted, given)
    else:
        _answers(out, wanted.papers, given, wanted.keys)


def _tables(out: Out, wanted: Options, given: Given) -> None:
    """The report on tables of marks."""
    found, unread = tables_of(wanted.tables, given.groups, wanted.most, wanted.lesson)
    out.sums([found.lesson], found.groups)
    out.report(table_report(found), [*unread, *found.refused], anything=bool(found.taken))


def _merged(out: Out, files: tuple[Path, ...], summary: Path | None) -> None:
    """The report on summaries of schools, and one summary of them all."""
    for folder in filter(Path.is_dir, files):  # a sum of them that lies there would count twice
        raise click.UsageError(
            f"--merge: “{folder}” is a folder. Name the summaries in it: {folder.as_posix()}/*.json"
        )
    report, whole, left_out = merged_report(files)
    if summary:
        write_whole(summary, whole)
    out.report(report, left_out, anything=bool(whole.lessons))


def _answers(out: Out, papers: Papers, given: Given, keys: Sequence[Path]) -> None:
    """The report on answer files, with every student."""
    reading = Reading.of([])
    for outcome in outcomes(sources(given.files)):
        reading.add(outcome)
    no_answers_as_keys(keys, reading.files)
    for name, text in given.codes:
        typed, bad = read_codes(text, reading.keys, name)
        reading.files += typed
        reading.refused += bad
    known(given.students, reading.files)
    reading.name(given.students)
    warn_of_empty(given.groups, [file.name for file in reading.files])
    sorted_ = placed(reading, given.groups)
    wanted = asked(reading, given.groups)
    report = class_report(*sorted_, wanted)
    if out.summary:
        out.sums(lessons_of_answers(sorted_[0], reading.keys, wanted), wanted.groups)
    papers.write(out, *sorted_[:2], wanted)
    for path in tables_in(given.files):
        told = said("{file} is a table, and read by --table alone", file=path.as_posix())
        out.say(told, err=True)
    out.report(report, [(r.name, r.reason) for r in reading.refused], anything=bool(reading.files))


def _written(out: Out, folder: Path, given: Given) -> None:
    """Answer files as a table, and the report on it."""
    done = write_answers(folder, given, partial(out.say, err=True))
    _country(out, [str(folder)], None, [], [(row.name, row.reason) for row in done.refused])


def _country(
    out: Out,
    tables: Sequence[str],
    backend: str | None,
    keys: Sequence[Path],
    refused: Sequence[tuple[str, str]],
) -> None:
    """The report on a table of answers."""
    report, lessons, groups = country_report(tables, backend, keys)
    out.sums(to_hand_on(lessons), groups)
    out.report(report, refused, anything=bool(report["files"]["counted"]))
