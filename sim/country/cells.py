"""Counts of students by what they did: small tables, whatever the number of answers.

All statistics of a report follow from four of them. `waiting`: questions with answers that a person
still has to read. `totals`: files by group and total. `cells`: answers by question, group, verdict,
marks, total, options. `pairs`: students by their totals before and after.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sim.country.beliefs_and_predictions import beliefs_in, predictions_in
from sim.country.counted import FORM, judged, sheets_of
from sim.country.refusal import CountryError
from sim.lesson.answer_file import PREDICTIONS
from sim.scene.said import said

MOST_CELLS = 2_000_000
"""Different rows of a count. A class of questions has thousands; a table with more is no such."""

Cell = Mapping[str, Any]
Topic = tuple[str, str, str, str]
"""Site, lesson, question, topic."""

OF_TOPICS = ("site", "lesson", "item", "topic")

OF_TOTALS = (*FORM, "group", "keyed", "foreign", "total")
OF_CELLS = (*FORM, "group", "keyed", "item", "position", "type", "worth", "verdict", "marks",
            "total", "sheet_foreign", "certain", "answered", "chosen")  # fmt: skip


@dataclass(frozen=True, slots=True)
class Counts:
    """The counts of a table, each a list of cells with a number of students `n`."""

    claims: list[Cell]
    groups: list[Cell]
    broken: list[Cell]
    nameless: int
    waiting: list[Cell]
    totals: list[Cell]
    cells: list[Cell]
    pairs: list[Cell]
    beliefs: list[Cell]
    predictions: list[Cell]
    topics: list[Cell]


def counts_of(answers: Any, topics: Sequence[Topic] = ()) -> Counts:
    """Works all of them out; raises `CountryError`. `topics`: of questions, that keys tell."""
    sheets = judged(sheets_of(answers)).cache()
    broken = sheets.filter(sheets.rows != sheets.sheet_rows).select("file", "rows", "sheet_rows")
    counting = sheets.filter(sheets.counts)
    mine = _with_sheets(answers, counting)
    waiting = _waiting(mine).cache()  # three counts ask for it
    totals = _totals(mine, waiting)
    whole = counting.left_join(totals, "sheet").drop("sheet_right")
    whole = whole.mutate(total=whole.total.fill_null(0)).cache()
    claims = sheets.group_by("claim").agg(n=sheets.count(), counted=sheets.counts.sum(),
                                          of=sheets.file.max())  # fmt: skip
    groups = sheets.group_by("group", "class").agg(
        n=sheets.count(), order=sheets.group_order.min(), first=sheets.sheet_order.min()
    )
    nameless = counting.filter(counting.student.strip() == "")
    return Counts(
        claims=_rows(claims), groups=_rows(groups), broken=_rows(broken.limit(1)),
        nameless=_rows(nameless.agg(n=nameless.count()))[0]["n"],
        waiting=_rows(waiting), totals=_rows(whole.group_by(OF_TOTALS).agg(n=whole.count())),
        cells=_rows(_cells(mine, whole)), pairs=_rows(_pairs(whole)),
        beliefs=_rows(beliefs_in(mine)), predictions=_rows(predictions_in(mine)),
        topics=_rows(_topics(mine, waiting, whole, topics)) if topics else [],
    )  # fmt: skip


def _with_sheets(answers: Any, counting: Any) -> Any:
    """Answers of files that count, with what the whole file is."""
    kept = counting.select("sheet", sheet_foreign=counting.foreign)
    return answers.join(kept, "sheet")


def _waiting(mine: Any) -> Any:
    """Questions worth marks with an unmarked answer in a file that is not foreign."""
    found = mine.filter(~mine.sheet_foreign, mine.worth > 0, mine.marks.isnull())
    return found.select(*FORM, "item").distinct()


def _counted(mine: Any, waiting: Any) -> Any:
    """Marked answers to questions that count."""
    worth = mine.filter(mine.position.notnull(), mine.worth > 0, mine.marks.notnull())
    return worth.anti_join(waiting, [*FORM, "item"])


def _totals(mine: Any, waiting: Any) -> Any:
    """Marks of each file in the questions that count."""
    counted = _counted(mine, waiting)
    return counted.group_by("sheet").agg(total=counted.marks.sum().cast("int64"))


def _cells(mine: Any, whole: Any) -> Any:
    """Answers to the wording of the key, or all answers that are no prediction without one."""
    asked = mine.filter(
        mine.item.notnull(), ~mine.foreign,
        (mine.keyed & mine.position.notnull()) | (~mine.keyed & mine.type.notin(PREDICTIONS)),
    )  # fmt: skip
    marked = asked.join(whole.select("sheet", "total"), "sheet")
    marked = marked.mutate(certain=marked.sure == "sure")
    return marked.group_by(OF_CELLS).agg(n=marked.count())


def _pairs(whole: Any) -> Any:
    """Students with both tests, marked with a key, by group and by both totals."""
    return _both(whole.filter(~whole.foreign, whole.keyed), [])


def _topics(mine: Any, waiting: Any, whole: Any, topics: Sequence[Topic]) -> Any:
    """The same topic by topic, with totals of its questions."""
    import ibis
    import pyarrow as pa

    rows = [dict(zip(OF_TOPICS, topic, strict=True)) for topic in topics]
    asked = ibis.memtable(pa.Table.from_pylist(rows))
    counted = _counted(mine, waiting).select("sheet", "site", "lesson", "item", "marks")
    parts = counted.join(asked, ["site", "lesson", "item"])
    totals = parts.group_by("sheet", "topic").agg(part=parts.marks.sum().cast("int64"))
    good = whole.filter(~whole.foreign, whole.keyed).drop("total").join(totals, "sheet")
    return _both(good.rename(total="part"), ["topic"])


def _both(good: Any, more: list[str]) -> Any:
    place = ["site", "lesson", "group", "person", *more]
    before = good.filter(good.form == "pre").select(*place, before="total")
    after = good.filter(good.form == "post").select(*place, after="total")
    both = before.join(after, place)
    kept = ["site", "lesson", "group", *more, "before", "after"]
    return both.group_by(kept).agg(n=both.count())


def _rows(table: Any) -> list[Cell]:
    return list(_read(table))


def _read(table: Any) -> Iterator[Cell]:
    found = table.limit(MOST_CELLS + 1).to_pyarrow()
    if found.num_rows > MOST_CELLS:
        raise CountryError(said(
            "there are more than {most} different kinds of answers: is this a table of the answers "
            "of lessons?", most=f"{MOST_CELLS:,}",
        ))  # fmt: skip
    for batch in found.to_batches(max_chunksize=10_000):
        yield from batch.to_pylist()
