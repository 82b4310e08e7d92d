"""The files of a class, as the wire delivers them: read in slices, then asked about.

    {"id": 7, "kind": "class", "do": "read", "files": [{"name": "a.zip", "base64": "…"}], "from": 0}
    {"id": 8, "kind": "class", "do": "read", "from": 250}
    {"id": 9, "kind": "class", "do": "report", "records": [[record, "7a"], …], "keys": […], …}
    {"id": 10, "kind": "class", "do": "save", "what": "html", "language": "ms", …as for a report}
    {"id": 11, "kind": "class", "do": "paper", "what": "slips", "language": "ms", "words": {…}, …}

A report with `tables` [{"name", "base64", "form", "group"}], and `most`, is about these tables of
marks; a save is about them and about `records`, as far as each is there. `codes`: what was typed,
a text for each of `groups`. `words`, of a report, a save and a paper: each English sentence in the
language of the page.

Reading answers with what is in the files, as rows that the page keeps: this side forgets them. A
slice ends after SLICE seconds; `next` says where to go on, or is null. Until then the files are
held here and not sent again. A Python that has come in the place of another has none: it says
`lost`, and gets them with the number of files that are known.
"""

from __future__ import annotations

import time
from array import array
from base64 import b64decode
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sim.classroom.files.codes import read_codes
from sim.classroom.files.keyed import KeyedForm, read_key_file
from sim.classroom.files.marks_file import given_marks, marks_file
from sim.classroom.files.reading import Outcome, Read, Reading, Refused, Source, outcomes
from sim.classroom.files.records import as_record, from_record
from sim.classroom.handouts.paper import Handout, handout
from sim.classroom.report.report import Asked, class_report
from sim.classroom.report.sentences import TITLES
from sim.classroom.show.class_csv import items_csv, students_csv
from sim.classroom.show.prose import prose
from sim.classroom.show.report_page import report_html
from sim.classroom.show.standalone import standalone
from sim.classroom.tables.dropped import dropped_report
from sim.scene.said import from_wire, in_words, wire

SLICE = 0.4
"""s. How long a page waits for a slice of files."""


@dataclass(slots=True)
class _Intake:
    """The files that are being read, and how many outcomes of them were handed on."""

    coming: Iterator[Outcome] = field(default_factory=lambda: iter(()))
    outcomes_sent: int = 0


_intake = _Intake()

Report = dict[str, Any]


def class_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """The header of the answer; there are no numbers beside it."""
    ways: dict[str, Callable[[Mapping[str, Any]], dict[str, Any]]] = {
        "read": _read,
        "report": _report,
        "save": _save,
        "paper": _paper,
        "ready": _ready,
    }
    return ways[str(request.get("do"))](request), array("d")


def _read(request: Mapping[str, Any]) -> dict[str, Any]:
    """Records, keys, marks and refusals of the next slice."""
    start = int(request.get("from") or 0)
    if "files" in request:
        _intake.coming, _intake.outcomes_sent = _outcomes(request["files"], start), start
    elif start != _intake.outcomes_sent:
        return {"lost": True}
    reading, end, following = Reading.of([]), 0.0, None
    for outcome in _intake.coming:
        reading.add(outcome)
        _intake.outcomes_sent += 1
        now = time.monotonic()
        end = end or now + SLICE  # what is known and skipped is in no slice
        if now > end:
            following = _intake.outcomes_sent
            break
    else:
        _intake.coming = iter(())
    return {
        "records": [as_record(read) for read in reading.files],
        "keys": [key.as_file() for key in reading.keys],
        "marks": marks_file(reading.given)["marks"],
        "refused": [[wire(row.name), wire(row.reason)] for row in reading.refused],
        "next": following,
    }


def _ready(_: Mapping[str, Any]) -> dict[str, Any]:
    """Imports what the tests need: on a slow computer that takes some seconds."""
    from sim.classroom.statistics.tails import t_quantile, t_two_sided

    return {"ready": t_two_sided(t_quantile(0.975, 9), 9) < 0.06}


def _outcomes(files: Sequence[Mapping[str, str]], skip: int) -> Iterator[Outcome]:
    return outcomes([Source(str(f["name"]), b64decode(f["base64"])) for f in files], skip=skip)


def _keys(texts: Sequence[str]) -> list[KeyedForm]:
    return [form for text in texts for form in read_key_file(text)]


def _given(
    request: Mapping[str, Any],
) -> tuple[list[tuple[Read, str]], list[KeyedForm], list[Refused], Asked]:
    """What a report is made of."""
    keys = _keys(request.get("keys") or [])
    groups = tuple(map(str, request["groups"]))
    files = [(from_record(row), str(group)) for row, group in request["records"]]
    bad: list[Refused] = []
    for group, text in zip(groups, request.get("codes") or [], strict=False):
        typed, no_codes = read_codes(str(text), keys)
        files += [(read, group) for read in typed]
        bad += no_codes
    refused = [Refused(from_wire(name), from_wire(reason))
               for name, reason in request.get("refused") or []]  # fmt: skip
    asked = Asked(
        groups=groups,
        given=given_marks(request.get("marks") or []),
        now=str(request.get("now") or ""),
        inference=bool(request.get("inference")),
    )
    return files, keys, [*refused, *bad], asked


def _made(request: Mapping[str, Any]) -> Report:
    return class_report(*_given(request))


def _paper(request: Mapping[str, Any]) -> dict[str, Any]:
    """Slips, the sheet of the class or the key, to be printed by the page."""
    files, keys, _, asked = _given(request)
    wanted = Handout(
        what=str(request["what"]),
        language=str(request["language"]),
        words=request["words"],
        answers=bool(request.get("answers")),
    )
    return {"html": handout(files, keys, asked, wanted)}


def _tables(request: Mapping[str, Any]) -> Report:
    most, inference = str(request.get("most") or ""), bool(request.get("inference"))
    return dropped_report(request["tables"], most, inference=inference)


def _report(request: Mapping[str, Any]) -> dict[str, Any]:
    """The report as HTML, and what the page itself needs of it."""
    told = request.get("words") or {}
    if request.get("tables"):
        report = _tables(request)
        return {"html": report_html(report, told), "words": []}
    report = _made(request)
    words = [
        _to_read(lesson, form, question, told)
        for lesson in report["lessons"]
        for form in lesson["forms"]
        for question in form["words"]
        if question["answers"]
    ]
    return {"html": report_html(report, told), "counted": report["files"]["counted"],
            "words": words, "inference": report["inference"]}  # fmt: skip


def _to_read(
    lesson: Mapping[str, Any],
    form: Mapping[str, Any],
    row: dict[str, Any],
    words: Mapping[str, str],
) -> dict[str, Any]:
    """Answers to be read, with what their question and each student are called on the page."""
    label = next(item["label"] for item in form["items"] if item["id"] == row["id"])
    names = (lesson["title"], TITLES.get(form["form"], form["form"]), label)
    return {
        **row, "lesson": lesson["lesson"], "form": form["form"],
        "title": " · ".join(in_words(name, words) for name in names),
        "ask": prose(row["ask"]),
        "rubric": {marks: prose(text) for marks, text in row["rubric"].items()},
        "answers": [{**one, "shown": in_words(one["student"], words)} for one in row["answers"]],
    }  # fmt: skip


def _save(request: Mapping[str, Any]) -> dict[str, Any]:
    """What is on the page as a file: html, csv or items."""
    reports = [_made(request)] if "records" in request else []
    if request.get("tables"):
        reports.append(_tables(request))
    what, words = request.get("what"), request.get("words") or {}
    if what == "html":
        return {"text": standalone(reports, words, str(request.get("language") or "en"))}
    rows = {"lessons": [lesson for report in reports for lesson in report["lessons"]]}
    return {"text": (items_csv if what == "items" else students_csv)(rows, words)}
