"""What a call of `carts class` means: files, tables or summaries, and the options of each."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import click

from sim.classroom.files.reading import Read, Reading, Refused
from sim.classroom.report.report import WHOLE, Asked
from sim.cli.classroom.files import group_of, with_slashes
from sim.country.typed_code_place import Beside, no_group

OF_ANSWERS = ("keys", "students", "marks", "codes")
"""Options that are made for answer files."""

READ_BEFORE = ("students", "marks", "codes", "groups")
"""What a table of answers holds since it was written."""


@dataclass(frozen=True, slots=True)
class Given:
    """Answer files as they were named. `groups`: name and pattern; `codes`: files of typed ones
    with what stands in them."""

    files: Sequence[Path]
    groups: list[tuple[str, str]]
    students: Mapping[str, str]
    codes: Sequence[tuple[str, str]]


def only_one_way(ctx: click.Context, files: Sequence[object], tables: Sequence[str]) -> None:
    """Answer files, tables or summaries, and to each the options that are made for it."""
    given = ctx.params
    merge, of_answers = given["merge"], any(given[name] for name in OF_ANSWERS)
    if not files and not tables and not given["codes"]:
        raise click.MissingParameter(ctx=ctx, param=ctx.command.params[0])
    if tables and (files or of_answers):
        raise click.UsageError("--table reads tables only: no answer files, keys, codes and marks")
    if (given["most"] or given["lesson"]) and not tables:
        raise click.UsageError("--max and --lesson belong to --table")
    if tables and given["summary"] and not given["lesson"]:
        raise click.UsageError(
            "--summary of a table needs --lesson NAME: the name of its file is not handed on"
        )
    if (tables or merge) and (given["slips"] or given["sheet"]):
        raise click.UsageError("--slips and --sheet are made from answer files")
    if merge and (tables or of_answers):
        raise click.UsageError("--merge adds summaries only: no tables, keys, codes and marks")
    if merge and given["groups"]:
        raise click.UsageError("--merge: the summaries name their groups, so no --group")
    if merge and given["csv_file"]:
        raise click.UsageError("--csv lists students: a summary has none")
    if given["backend"]:
        raise click.UsageError("--backend belongs to --table with a table of answers")


def only_country(ctx: click.Context, parquet: object, tables: Sequence[str]) -> None:
    """A table of answers is written from files, or read; it lists no students."""
    given = ctx.params
    if given["slips"] or given["sheet"]:
        raise click.UsageError("--slips and --sheet are made from answer files, without a table")
    if parquet:
        if not given["files"] and not given["codes"]:
            raise click.MissingParameter(ctx=ctx, param=ctx.command.params[0])
        others = ("merge", "backend", "most", "lesson")
        if tables or any(given[name] for name in others):
            raise click.UsageError(
                "--parquet writes answer files into a table: no --table, --merge, --backend, "
                "--max and --lesson"
            )
    elif any(given[name] for name in (*READ_BEFORE, "files", "merge", "most", "lesson")):
        raise click.UsageError(
            "--table with a table of answers: groups, codes and marks were given when it was "
            "written; only --key goes with it"
        )
    if given["csv_file"]:
        raise click.UsageError("--csv lists students: a report on a table of answers has none")


def student(text: str) -> tuple[str, str]:
    """A file and the code word it lacks, of FILE=CODE."""
    name, equals, code = text.rpartition("=")
    if not (name.strip() and equals and code.strip()):
        raise click.UsageError(f"--student {text}: write FILE=CODE, for example a.json=BLUE-FOX-27")
    return with_slashes(name.strip()), code.strip()


def group(text: str) -> tuple[str, str]:
    """A group and its pattern, of NAME=GLOB. Windows' cmd hands single quotes on as they are."""
    name, equals, pattern = (part.strip("'") for part in text.strip("'").partition("="))
    if not (name.strip() and equals and pattern):
        raise click.UsageError(f'--group {text}: write NAME=GLOB, for example "new=class-7a/*"')
    return name.strip(), with_slashes(pattern)


def known(students: Mapping[str, str], files: Sequence[Read]) -> None:
    """Refuses a code word for a file that was not read, or that has one of its own."""
    for name, code in students.items():
        mine = [file for file in files if f"/{file.name}".endswith(f"/{name}")]
        if not mine:
            raise click.UsageError(f"--student {name}={code}: no file of this name was read")
        own = next((s for file in mine if (s := file.answers.student.strip())), "")
        if own and len(mine) == 1:
            raise click.UsageError(
                f"--student {name}={code}: this file has the code word {own} already"
            )


def no_answers_as_keys(keys: Sequence[Path], files: Sequence[Read]) -> None:
    """Refuses a file of answers in the place of a key: it would be one more student."""
    names = {file.name for file in files}
    for key in keys:
        if key.as_posix() in names:
            raise click.UsageError(f"--key {key}: this is a file of answers; carts key writes keys")


def warn_of_empty(groups: Sequence[tuple[str, str]], names: Sequence[str]) -> None:
    """One line for each pattern that no file fits."""
    for group, pattern in groups:
        if not any(group_of(name, [(group, pattern)]) for name in names):
            click.echo(f"warning: --group {group}={pattern}: no file fits it", err=True)


def placed(
    reading: Reading, groups: list[tuple[str, str]]
) -> tuple[list[tuple[Read, str]], Any, list[Refused]]:
    """Files with their groups; what is in no group is refused in words. A typed code is where the
    pattern of its file puts it, else where its student's other files are."""
    if not groups:
        return [(file, WHOLE) for file in reading.files], reading.keys, reading.refused
    found = [(file, group_of(file.name, groups)) for file in reading.files]
    beside = Beside[str]()
    for file, name in found:
        if name:
            beside.add(file, name)
    found = [(file, name or beside.of(file) or "") for file, name in found]
    reading.refused += [Refused(file.name, no_group(file)) for file, name in found if not name]
    return [(f, name) for f, name in found if name], reading.keys, reading.refused


def asked(reading: Reading, groups: list[tuple[str, str]]) -> Asked:
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
