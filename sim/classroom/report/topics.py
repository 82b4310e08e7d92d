"""Before and after, topic by topic: the first law beside the third, as the paper did it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.refusal import FEWEST, RefusalError
from sim.classroom.report.marked import Marked
from sim.classroom.report.pairing import pair_up
from sim.classroom.report.sentences_of_two import ADJUSTED, of_difference
from sim.classroom.statistics.adjusted import adjusted
from sim.classroom.statistics.gain import hake_gain
from sim.classroom.statistics.pair_sums import NOBODY, PairSums
from sim.scene.said import said

FEWEST_ITEMS = 3
"""Questions of a topic; with fewer a single one would decide."""


@dataclass(frozen=True, slots=True)
class TopicSums:
    """A topic of a test: its number of questions, their marks, and each group before and after."""

    topic: str
    questions: int
    of: float
    groups: Mapping[str, PairSums]


def topic_sums(
    by_form: Mapping[str, Sequence[Marked]], key: KeyedForm | None, groups: Sequence[str]
) -> Iterator[TopicSums]:
    """Each topic of a test with the groups that took the same questions of it twice."""
    if key is None or "pre" not in by_form or "post" not in by_form:
        return
    for topic, items in topics_of(key).items():
        found = [pair_up(by_form["pre"], by_form["post"], group, items) for group in groups]
        pairs = [one for one in found if one and one.same_items]
        if pairs:
            sums = {one.group: one.sums for one in pairs}
            yield TopicSums(topic, len(items), pairs[0].of, sums)


def topic_rows(topics: Iterable[TopicSums]) -> list[dict[str, Any]]:
    """One row for each topic and group in which enough took both tests."""
    return [
        {
            "topic": one.topic, "questions": one.questions, "group": group, "n": sums.n,
            "of": one.of, "pre": asdict(sums.before), "post": asdict(sums.after),
            "gain": _gain(sums.before.mean, sums.after.mean, one.of),
        }
        for one in topics
        for group, sums in one.groups.items()
        if sums.n >= FEWEST
    ]  # fmt: skip


def topic_differences(topics: Iterable[TopicSums], groups: Sequence[str]) -> list[dict[str, Any]]:
    """How two groups differ in each topic, adjusted for the test before.

    Without p: of several topics one would be small by luck.
    """
    rows = []
    for one in topics:
        if len(groups) != 2 or any(one.groups.get(group, NOBODY).n < FEWEST for group in groups):
            continue
        names = (groups[0], groups[1])
        first, second = (one.groups[group].both for group in names)
        try:
            test = adjusted(first, second).test
        except RefusalError:
            continue  # what is said of the whole test tells why
        what = said("{topic}: {what}", topic=one.topic, what=ADJUSTED)
        sentence = of_difference(what, test, names, with_p=False)
        found = {"difference": test.difference, "low": test.low, "high": test.high}
        rows.append({"topic": one.topic, "groups": list(names), **found, "sentence": sentence})
    return rows


def topics_of(key: KeyedForm) -> dict[str, list[str]]:
    """The topics of a form that are worth a row, each with its questions."""
    topics: dict[str, list[str]] = {}
    for name, item in key.items.items():
        for topic in item.question.common.topics:
            topics.setdefault(topic, []).append(name)
    return {
        topic: items
        for topic, items in topics.items()
        if FEWEST_ITEMS <= len(items) < len(key.items)
    }


def _gain(before: float, after: float, of: float) -> float | None:
    try:
        return hake_gain(before, after, of)
    except RefusalError:
        return None
