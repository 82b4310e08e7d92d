"""Before and after by topic, from counts of students by both totals in its questions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from sim.classroom.report.topics import TopicSums, topics_of
from sim.classroom.statistics.pair_sums import pair_sums_of
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.sums import LessonSums
from sim.country.cells import Cell, Topic
from sim.country.sums import Keys
from sim.lesson.csv_text import safe_text


def topics_in(keys: Keys) -> list[Topic]:
    """The questions of all topics that are worth a row."""
    return [
        (safe_text(site), safe_text(lesson), item, topic)
        for (site, lesson, form), key in keys.items()
        if form == "pre"
        for topic, items in topics_of(key).items()
        for item in items
    ]


def topic_sums_of(
    lesson: LessonSums, cells: Sequence[Cell], keys: Keys, groups: Sequence[str]
) -> Iterator[TopicSums]:
    """The topics of a lesson, in the order of its key."""
    key = keys.get((lesson.site, lesson.lesson, "pre"))
    if key is None or not {"pre", "post"} <= lesson.forms.keys():
        return
    counted = [{*lesson.forms[form].counted} for form in ("pre", "post")]
    for topic, items in topics_of(key).items():
        before, after = ({*items} & known for known in counted)
        of = sum(_worth(lesson, name) for name in before)
        if before != after or not of:
            continue
        sums = {group: pair_sums_of(_pairs(cells, lesson, topic, group), of) for group in groups}
        yield TopicSums(topic, len(items), float(of), sums)


def _worth(lesson: LessonSums, name: str) -> Exact:
    metas = lesson.forms["pre"].items
    return next((meta["worth"] for meta in metas if meta["id"] == name), 0)


def _pairs(
    cells: Sequence[Cell], lesson: LessonSums, topic: str, group: str
) -> Mapping[tuple[Exact, Exact], int]:
    found: Counter[tuple[Exact, Exact]] = Counter()
    place = (lesson.site, lesson.lesson, topic, group)
    for cell in cells:
        if (cell["site"], cell["lesson"], cell["topic"], cell["group"]) == place:
            found[cell["before"], cell["after"]] += cell["n"]
    return found
