"""Answers of a country from a seed: the same for everybody who makes them.

A bank of 24 choices and two texts, students of different ability, a test before and one after. The
same students come out as files and as rows of a table.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cache
from itertools import count
from pathlib import Path

from sim.classroom.files.keyed import read_key_file
from sim.classroom.files.reading import Read
from sim.classroom.report.marked import Keys, mark_file
from sim.classroom.report.report import Asked
from sim.classroom.summary.handed_on import handed_on
from sim.classroom.summary.written import summary_file
from sim.cli.classroom.summary import lessons_of_answers
from sim.country.rows import Place, rows_of
from sim.country.write import TableWriter, new_folder, write_keys
from sim.lesson.answer_file import AnswerFile, read_answer_file
from tests.classroom.given.makers import bank, keys, random_class

BANK = bank(24, words=2)
KEY = keys(BANK)
SCHOOL = 100
"""Students of a school."""

DIFFERENT = 40
"""Schools with answers of their own; the next ones give the same answers under other names."""

NAME = "SCHOOL-X"
ASKED = "What is the force on {} by the other cart, and why? " * 20
SAID = "Look at both arrows, and at what each of them acts on. " * 10


@cache
def drawn(number: int, students: int, seed: int) -> tuple[tuple[str, AnswerFile], ...]:
    """The files of a school, without its name: the text as the page writes it, and as it is read.

    Files are 50 kB each: the page writes the text of every question into them.
    """
    found = []
    for file in random_class(BANK, students, seed=seed + number, prefix=NAME):
        read = read_answer_file(json.dumps(file))
        for item in file["items"]:
            item["asked"], item["said"] = ASKED.replace("{}", item["id"]), SAID
        found.append((json.dumps(file), read))
    return tuple(found)


def schools(
    files: int, seed: int, students: int = SCHOOL
) -> Iterator[tuple[str, list[tuple[str, AnswerFile]]]]:
    """School by school, before and after of each student, until there are so many files."""
    for number in count():
        if files <= 0:
            return
        made = drawn(number % DIFFERENT, students, seed)[:files]
        files -= len(made)
        name = f"S{number:07}"  # as long as NAME
        yield (
            name,
            [
                (text, replace(read, student=read.student.replace(NAME, name)))
                for text, read in made
            ],
        )


def write_files(folder: Path, files: int, seed: int = 1) -> None:
    """Answer files, a folder a school, and the key."""
    for name, made in schools(files, seed):
        (folder / name).mkdir(parents=True)
        for text, read in made:
            path = folder / name / f"{read.student}.{read.form}.carts.json"
            path.write_text(text.replace(NAME, name), encoding="utf-8")
    (folder / "key.json").write_text(KEY, encoding="utf-8")


def write_answers(folder: Path, answers: int, seed: int = 1) -> None:
    """A table of at least so many answers to questions."""
    per_file = sum(len(read.items) for _, read in drawn(0, SCHOOL, seed)) / (2 * SCHOOL)
    _write_table(folder, schools(round(answers / per_file) + 1, seed))


def write_summaries(folder: Path, number: int, students: int, seed: int = 1) -> None:
    """A summary of each of `number` schools, and one table of all their answers beside them."""
    found = list(read_key_file(KEY))
    made = list(schools(2 * students * number, seed, students))
    for name, files in made:
        reads = [(Read(f"{name}/{k}", read), "class") for k, (_, read) in enumerate(files)]
        sums = handed_on(lessons_of_answers(reads, found, Asked()), ["class"], by_total=True)
        text = json.dumps(summary_file(sums))
        (folder / f"{name}.json").write_text(text, encoding="utf-8")
    _write_table(folder / "whole", made)


def _write_table(folder: Path, made: Iterable[tuple[str, list[tuple[str, AnswerFile]]]]) -> None:
    found = read_key_file(KEY)
    of_files, place = Keys(found), 0
    new_folder(folder)
    with TableWriter(folder) as table:
        for name, files in made:
            for _, read in files:
                place += 1
                shown = f"{name}/{read.student}.{read.form}.carts.json"
                key = of_files.of(read)
                marked = mark_file(Read(shown, read), "class", key, {})
                table.add(rows_of(marked, Place("class", 1, "", place), key))
    write_keys(folder, found)
