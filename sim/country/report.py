"""The report on a table of answers, without a single student in it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.report.flags.flag import Flag
from sim.classroom.report.marked import Keys
from sim.classroom.report.topics import topic_differences, topic_rows
from sim.classroom.summary.document import Read, document
from sim.classroom.summary.sums import LessonSums
from sim.country.beliefs_and_predictions import belief_rows_of, prediction_rows_of
from sim.country.cells import Cell, Counts, counts_of
from sim.country.item_cells import difficulty_of_all
from sim.country.refusal import CountryError
from sim.country.sums import cells_of, groups_of, lessons_of, of_counted
from sim.country.topics import topic_sums_of, topics_in
from sim.lesson.csv_text import safe_text
from sim.scene.said import counted, said

SAYS: Mapping[str, tuple[str, Callable[[int], str]]] = {
    "same": ("same-file", lambda n: counted(
        "1 file holds the answers of another file of its code word: these count once. Is that what "
        "happened? It is:",
        "{n} files hold the answers of another file of their code word: these count once. Is that "
        "what happened? One of them:", n=n)),
    "again": ("saved-again", lambda n: counted(
        "1 file was saved by a student who saved again: the last one counts. Is that what "
        "happened? It is:",
        "{n} files were saved by students who saved again: the last one counts. Is that what "
        "happened? One of them:", n=n)),
    "doubled": ("doubled-id", lambda n: counted(
        "1 file shares its code word and differs: it does not count. Is that what happened? It is:",
        "{n} files share a code word and differ: none of them counts. Is that what happened? One "
        "of them:", n=n)),
}  # fmt: skip


def read_table(
    answers: Any, keys: Sequence[KeyedForm]
) -> tuple[dict[str, Any], list[LessonSums], tuple[str, ...]]:
    """The report, the sums that may be handed on, and the groups; raises `CountryError`."""
    try:
        return _read(answers, keys)
    except (CountryError, ModuleNotFoundError):
        raise
    except Exception as error:  # a table of somebody else's, a backend with errors of its own
        text = next(iter(str(error).splitlines()), "")[:200]
        name = type(error).__name__
        raise CountryError(
            said("this table cannot be read ({error}: {text})", error=name, text=text)
        ) from error


def _read(
    answers: Any, keys: Sequence[KeyedForm]
) -> tuple[dict[str, Any], list[LessonSums], tuple[str, ...]]:
    of_forms = {
        (safe_text(site), safe_text(lesson), form): key
        for (site, lesson, form), key in Keys(keys).main.items()
    }
    counts = counts_of(answers, topics_in(of_forms))
    for cell in counts.broken:
        raise CountryError(said(
            "{file}: {n} of its {all} rows are there. Is a part of the table missing, or does it "
            "stand here twice?",
            file=cell["file"], n=f"{cell['rows']}", all=f"{cell['sheet_rows']}",
        ))  # fmt: skip
    lessons = lessons_of(counts, of_forms)
    groups, _ = groups_of(counts)
    read = Read(
        unit="files", read=sum(cell["n"] for cell in counts.claims),
        counted=sum(cell["counted"] for cell in counts.claims),
        flags=[asdict(flag) for flag in _flags(counts)], notes=_notes(counts),
    )  # fmt: skip
    report = document(lessons, groups, read)
    for row, lesson in zip(report["lessons"], lessons, strict=True):
        topics = list(topic_sums_of(lesson, counts.topics, of_forms, groups))
        row["topics"] = topic_rows(topics)
        row["topic_differences"] = topic_differences(topics, groups)
        for form in row["forms"]:
            place = (lesson.site, lesson.lesson, form["form"])
            key = of_forms.get(place)
            difficulty_of_all(form["items"], lesson.forms[form["form"]].counted,
                              cells_of(counts.cells, place))  # fmt: skip
            form["beliefs"] = belief_rows_of(cells_of(counts.beliefs, place), key)
            form["predictions"] = prediction_rows_of(cells_of(counts.predictions, place))
    return report, lessons_of(of_counted(counts), of_forms), groups


def _flags(counts: Counts) -> list[Flag]:
    """Questions to whoever reads: with an example, for the files may be millions."""
    flags = []
    for claim, (code, words) in SAYS.items():
        found: list[Cell] = [cell for cell in counts.claims if cell["claim"] == claim]
        if found:
            n = sum(cell["n"] for cell in found)
            flags.append(Flag(code, words(n), tuple(cell["of"] for cell in found)))
    if counts.nameless:
        text = counted("1 file has no code word: it counts as a person of its own.",
                       "{n} files have no code word: each counts as a person of its own.",
                       n=counts.nameless)  # fmt: skip
        flags.append(Flag("no-code", text, ()))
    foreign = sum(cell["n"] for cell in counts.totals if cell["foreign"])
    if foreign:
        text = counted(
            "1 file answers another text of some questions: these answers are not counted and the "
            "file has no total; its other answers are counted.",
            "{n} files answer another text of some questions: these answers are not counted and "
            "the files have no total; their other answers are counted.",
            n=foreign,
        )
        flags.append(Flag("foreign-version", text, ()))
    return flags


def _notes(counts: Counts) -> list[str]:
    keyed = {(c["site"], c["lesson"], c["form"]) for c in counts.totals if c["keyed"]}
    left = sum(
        cell["n"]
        for cell in counts.totals
        if not cell["keyed"] and (cell["site"], cell["lesson"], cell["form"]) in keyed
    )
    if not left:
        return []
    return [counted(
        "1 file was written without the key that others had: it is not counted.",
        "{n} files were written without the key that others had: they are not counted.", n=left,
    )]  # fmt: skip
