"""Slips, sheet and key as files of their own, and as what a page prints."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.files.reading import Read
from sim.classroom.handouts.class_sheet import sheet_html
from sim.classroom.handouts.key_page import key_html
from sim.classroom.handouts.slip import slips
from sim.classroom.handouts.slip_page import slips_html
from sim.classroom.report.marked import Keys
from sim.classroom.report.report import Asked, class_report, sorted_files
from sim.classroom.show.html_parts import telling
from sim.classroom.show.standalone import whole_file
from sim.scene.said import in_words, template

TITLES = {
    "slips": template("Feedback slips"),
    "sheet": template("Page of the class"),
    "key": template("Answers and rubrics"),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Handout:
    """What is wanted: `what` is slips, sheet or key, which needs no files.

    `words`: each English sentence in the language.
    `answers`: slips with the right answers.
    """

    what: str
    language: str = "en"
    words: Mapping[str, str]
    answers: bool = False


def handout(
    files: Iterable[tuple[Read, str]], keys: Sequence[KeyedForm], asked: Asked, wanted: Handout
) -> str:
    """The HTML of a hand-out, without a page around it."""
    tell = telling(wanted.words)
    if wanted.what == "key":
        return key_html(keys, tell)
    if wanted.what == "sheet":
        return sheet_html(class_report(files, keys, (), asked), tell)
    of_files = Keys(keys)
    counted = sorted_files(files, of_files, asked).counted
    return slips_html(slips(counted, of_files, asked.groups), tell, answers=wanted.answers)


def handout_file(html: str, wanted: Handout) -> str:
    """A file to be printed."""
    return whole_file(html, in_words(TITLES[wanted.what], wanted.words), paper_style(),
                      wanted.language)  # fmt: skip


def paper_style() -> str:
    """The style of hand-outs, as the page has it too."""
    return Path(__file__).with_name("paper.css").read_text(encoding="utf-8")
