"""What a group gained, and two groups beside each other: numbers, refusals and sentences.

Without `inference` (scipy is not there yet) only what needs no distribution is computed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from typing import Any

from sim.classroom.refusal import FEWEST, RefusalError, at_least
from sim.classroom.report import sentences as say
from sim.classroom.report.pairing import Pairs
from sim.classroom.statistics.adjusted import adjusted, pairs_of
from sim.classroom.statistics.compare import (
    TTest,
    cohen_d,
    cohen_d_within,
    paired_t,
    paper_z,
    welch,
)
from sim.classroom.statistics.gain import at_the_edges, hake_gain
from sim.classroom.statistics.ranks import wilcoxon
from sim.classroom.statistics.spread import Spread, differences, spread

D_WITHIN = "the gain divided by √((s₁² + s₂²)/2) of the two tests"
D_BETWEEN = "the difference of the mean gains divided by their pooled standard deviation"


class Told:
    """Collects numbers, sentences and refusals of one table."""

    def __init__(self) -> None:
        self.numbers: dict[str, Any] = {}
        self.sentences: list[str] = []
        self.refusals: list[str] = []

    def tell(self, name: str, make: Callable[[], tuple[Any, str]]) -> Any:
        """Adds a number and its sentence, or the reason why there is none."""
        try:
            value, sentence = make()
        except RefusalError as refused:
            self.numbers[name] = None
            reason = f"{name.replace('_', ' ')}: {refused}"
            self.refusals.append(reason)
            return None
        self.numbers[name] = value
        if sentence:
            self.sentences.append(sentence)
        return value

    def note(self, sentence: str) -> None:
        """Adds a sentence without a number, once."""
        if sentence and sentence not in self.sentences:
            self.sentences.append(sentence)


def gain_table(pairs: Pairs, *, inference: bool) -> dict[str, Any]:
    """The gain of one group: gain, d, change with interval, Wilcoxon."""
    told = Told()
    n = len(pairs.students)
    row: dict[str, Any] = {
        "group": pairs.group, "n": n, "of": pairs.of, "students": list(pairs.students),
        "before": list(pairs.before), "after": list(pairs.after),
        "without_before": list(pairs.without_before), "without_after": list(pairs.without_after),
        "pre": None, "post": None,
    }  # fmt: skip
    if n < FEWEST:
        missing = f"{n} students took both tests: no statistics for fewer than {FEWEST}."
        return {**row, **told.numbers, "sentences": [missing], "refusals": []}
    before, after = spread(pairs.before), spread(pairs.after)
    row |= {"pre": asdict(before), "post": asdict(after)}
    told.tell("gain", lambda: _hake(before, after, pairs.of))
    for marks, test in ((pairs.before, "Before"), (pairs.after, "After")):
        edge = say.of_edges(*at_the_edges(marks, pairs.of))
        told.note(f"{test}: {edge}" if edge else "")
    if inference:
        told.tell("change", lambda: _change(pairs))
        told.tell("wilcoxon", lambda: _ranks(pairs))
    told.tell("d", lambda: _within(before, after))
    if pairs.same_items:
        told.note(say.SAME_FORM)
    return {**row, **told.numbers, "sentences": told.sentences, "refusals": told.refusals}


def _hake(before: Spread, after: Spread, of: float) -> tuple[float, str]:
    gain = hake_gain(before.mean, after.mean, of)
    return gain, say.of_gain(gain, before, after, of)


def _change(pairs: Pairs) -> tuple[dict[str, Any], str]:
    test = paired_t(pairs.after, pairs.before)
    return asdict(test), say.of_change(test)


def _ranks(pairs: Pairs) -> tuple[dict[str, Any], str]:
    found = wilcoxon(pairs.after, pairs.before)
    return asdict(found), say.of_ranks(found)


def _within(before: Spread, after: Spread) -> tuple[float, str]:
    d = cohen_d_within(before, after)
    return d, say.of_effect(d, D_WITHIN)


def comparison_table(one: Pairs, other: Pairs, *, classes: int, inference: bool) -> dict[str, Any]:
    """`one` minus `other`: baseline first, then the adjusted difference, then the gains.

    `classes`: how many classes each group has at least; with one, no p is shown for teaching.
    """
    told = Told()
    groups = (one.group, other.group)
    row: dict[str, Any] = {
        "groups": list(groups), "n": [len(one.students), len(other.students)],
        "p_shown": classes > 1,
    }  # fmt: skip
    for pairs in (one, other):
        if len(pairs.students) < FEWEST:
            text = (
                f"{len(pairs.students)} students of “{pairs.group}” took both tests: no comparison "
                f"with fewer than {FEWEST}."
            )
            return {**row, "sentences": [text], "refusals": []}
    first, second = spread(one.before), spread(other.before)
    told.tell("baseline", lambda: _baseline(first, second, groups, inference=inference))
    if inference:
        told.tell("adjusted", lambda: _adjusted(one, other, groups, with_p=classes > 1))
    gains = [spread(differences(pairs.after, pairs.before)) for pairs in (one, other)]
    row["gain_spreads"] = [asdict(gain) for gain in gains]
    if inference:
        told.tell("welch", lambda: _welch("Raw gains", gains, groups, with_p=classes > 1))
    told.tell("paper_z", lambda: _paper_z(gains))
    told.tell("d", lambda: _between(gains))
    if classes < 2:
        told.note(say.ONE_CLASS)
    return {**row, **told.numbers, "sentences": told.sentences, "refusals": told.refusals}


def _baseline(
    first: Spread, second: Spread, groups: tuple[str, str], *, inference: bool
) -> tuple[dict[str, Any], str]:
    z = paper_z(first, second)
    test = welch(first, second) if inference else None
    table = {"z": z.z, **({"difference": test.difference, "low": test.low, "high": test.high}
                          if test else {})}  # fmt: skip
    return table, say.of_baseline(test, z, groups)


def _adjusted(
    one: Pairs, other: Pairs, groups: tuple[str, str], *, with_p: bool
) -> tuple[dict[str, Any], str]:
    found = adjusted(pairs_of(one.before, one.after), pairs_of(other.before, other.after))
    text = say.of_difference("Adjusted for the start (ANCOVA)", found.test, groups, with_p=with_p)
    return {"slope": found.slope, **asdict(found.test)}, text


def _welch(
    what: str, spreads: list[Spread], groups: tuple[str, str], *, with_p: bool
) -> tuple[dict[str, Any], str]:
    test: TTest = welch(*spreads)
    return asdict(test), say.of_difference(what, test, groups, with_p=with_p)


def _paper_z(gains: list[Spread]) -> tuple[dict[str, float], str]:
    found = paper_z(*gains)
    text = f"The paper's Z of the raw gains, equation (4), is {say.signed(found.z)}."
    return asdict(found), text


def _between(gains: list[Spread]) -> tuple[float, str]:
    d = cohen_d(*gains)
    return d, say.of_effect(d, D_BETWEEN)


def only_after_table(
    form: str, spreads: list[Spread], groups: tuple[str, str], *, classes: int
) -> dict[str, Any]:
    """Two groups on a form that has no earlier one to compare with. Needs scipy."""
    told = Told()
    told.tell("welch", lambda: _welch(f"Form {form}", spreads, groups, with_p=classes > 1))
    told.tell("paper_z", lambda: _paper_z_of(spreads))
    return {"form": form, **told.numbers, "sentences": told.sentences, "refusals": told.refusals}


def _paper_z_of(spreads: list[Spread]) -> tuple[dict[str, float], str]:
    for group in spreads:
        at_least(group.n, FEWEST)
    return asdict(paper_z(*spreads)), ""
