"""What a group gained, and two groups beside each other: numbers, refusals and sentences.

Without `inference` (scipy is not there yet) only what needs no distribution is computed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict
from fractions import Fraction
from typing import Any

from sim.classroom.refusal import FEWEST, RefusalError, at_least
from sim.classroom.report import sentences as say
from sim.classroom.report import sentences_of_two as two
from sim.classroom.report.pairing import Pairs
from sim.classroom.statistics.adjusted import adjusted
from sim.classroom.statistics.compare import (
    TTest,
    change_of,
    cohen_d,
    cohen_d_within,
    paper_z,
    welch,
)
from sim.classroom.statistics.gain import hake_gain
from sim.classroom.statistics.pair_sums import PairSums
from sim.classroom.statistics.ranks import signed_ranks
from sim.classroom.statistics.spread import Spread
from sim.scene.said import Said, reason_of, said, template

NAMES = {
    "gain": template("gain"),
    "change": template("change"),
    "wilcoxon": template("wilcoxon"),
    "d": "d",
    "baseline": template("baseline"),
    "adjusted": template("adjusted difference"),
    "welch": template("difference of the means"),
    "paper_z": template("paper's Z"),
    "clustered": template("by classes"),
}
"""What a number is called where there is none."""

EDGES = {"before": template("Before: {says}"), "after": template("After: {says}")}


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
            self.refusals.append(why_not(name, refused))
            return None
        self.numbers[name] = value
        if sentence:
            self.sentences.append(sentence)
        return value

    def note(self, sentence: str) -> None:
        """Adds a sentence without a number, once."""
        if sentence and sentence not in self.sentences:
            self.sentences.append(sentence)


def why_not(name: str, refused: RefusalError) -> str:
    """Why a number is not given."""
    return said("{name}: {reason}", name=NAMES[name], reason=reason_of(refused))


def gain_table(pairs: Pairs, *, inference: bool) -> dict[str, Any]:
    """The gain of one group: gain, d, change with interval, Wilcoxon."""
    lists: dict[str, list[Any]] = {
        "students": list(pairs.students),
        "before": list(pairs.before), "after": list(pairs.after),
        "without_before": list(pairs.without_before), "without_after": list(pairs.without_after),
        "of_another_text": list(pairs.of_another_text),
    }  # fmt: skip
    return gain_row(
        pairs.group, pairs.sums, pairs.of, same_items=pairs.same_items, inference=inference,
        lists=lists,
    )  # fmt: skip


def gain_row(
    group: str,
    sums: PairSums,
    of: float | None,
    *,
    same_items: bool,
    inference: bool,
    lists: Mapping[str, list[Any]],
) -> dict[str, Any]:
    """The same from sums; `lists`: who it is, where that is known. `of` None: nobody knows it."""
    told = Told()
    n = sums.n
    row: dict[str, Any] = {"group": group, "n": n, "of": of, "of_another_text": [], **lists,
                           "pre": None, "post": None}  # fmt: skip
    if n < FEWEST:
        missing = say.too_few_pairs(n, FEWEST)
        return {**row, **told.numbers, "sentences": [missing], "refusals": []}
    before, after = sums.before, sums.after
    row |= {"pre": asdict(before), "post": asdict(after)}
    told.tell("gain", lambda: _hake(before, after, of))
    told.numbers["gain_of_students"] = _of_students(sums)
    for zero, full, test in (
        (sums.zero_before, sums.full_before, "before"),
        (sums.zero_after, sums.full_after, "after"),
    ):
        edge = say.of_edges(zero / n, full / n)
        told.note(Said(EDGES[test], {"says": edge}) if edge else "")
    if inference:
        told.tell("change", lambda: _change(sums))
        told.tell("wilcoxon", lambda: _ranks(sums))
    told.tell("d", lambda: _within(before, after))
    if same_items:
        told.note(say.SAME_FORM)
    return {**row, **told.numbers, "sentences": told.sentences, "refusals": told.refusals}


def _of_students(sums: PairSums) -> dict[str, Any] | None:
    """The mean of the gains of the students who could gain; how many they are."""
    if not sums.gained:
        return None
    return {"mean": float(Fraction(sums.shares) / sums.gained), "n": sums.gained}


def _hake(before: Spread, after: Spread, of: float | None) -> tuple[float, str]:
    if of is None:
        raise RefusalError(say.NO_MOST)
    gain = hake_gain(before.mean, after.mean, of)
    return gain, say.of_gain(gain, before, after, of)


def _change(sums: PairSums) -> tuple[dict[str, Any], str]:
    test = change_of(sums.gain)
    return asdict(test), say.of_change(test)


def _ranks(sums: PairSums) -> tuple[dict[str, Any], str]:
    found = signed_ranks(sums.differences)
    return asdict(found), say.of_ranks(found)


def _within(before: Spread, after: Spread) -> tuple[float, str]:
    d = cohen_d_within(before, after)
    return d, say.of_effect(d, say.D_WITHIN)


def comparison_table(one: Pairs, other: Pairs, *, classes: int, inference: bool) -> dict[str, Any]:
    """`one` minus `other`: baseline first, then the adjusted difference, then the gains.

    `classes`: how many classes each group has at least; with one, no p is shown for teaching.
    """
    groups = (one.group, other.group)
    return comparison_row(
        groups, one.sums, other.sums, with_p=classes > 1, inference=inference,
        says=two.ONE_CLASS if classes < 2 else "",
    )  # fmt: skip


def comparison_row(
    groups: tuple[str, str],
    one: PairSums,
    other: PairSums,
    *,
    with_p: bool,
    inference: bool,
    says: str,
) -> dict[str, Any]:
    """The same from sums; `says`: what may be concluded from groups that are classes."""
    told = Told()
    row: dict[str, Any] = {"groups": list(groups), "n": [one.n, other.n], "p_shown": with_p}
    for group, sums in zip(groups, (one, other), strict=True):
        if sums.n < FEWEST:
            return {**row, "sentences": [two.too_few(sums.n, group, FEWEST)], "refusals": []}
    first, second = one.before, other.before
    told.tell("baseline", lambda: _baseline(first, second, groups, inference=inference))
    if inference:
        told.tell("adjusted", lambda: _adjusted(one, other, groups, with_p=with_p))
    gains = [one.gain, other.gain]
    row["gain_spreads"] = [asdict(gain) for gain in gains]
    if inference:
        told.tell("welch", lambda: _welch(two.RAW_GAINS, gains, groups, with_p=with_p))
    told.tell("paper_z", lambda: _paper_z(gains))
    told.tell("d", lambda: _between(gains))
    told.note(says)
    return {**row, **told.numbers, "sentences": told.sentences, "refusals": told.refusals}


def _baseline(
    first: Spread, second: Spread, groups: tuple[str, str], *, inference: bool
) -> tuple[dict[str, Any], str]:
    z = paper_z(first, second)
    test = welch(first, second) if inference else None
    table = {"z": z.z, **({"difference": test.difference, "low": test.low, "high": test.high}
                          if test else {})}  # fmt: skip
    return table, two.of_baseline(test, z, groups)


def _adjusted(
    one: PairSums, other: PairSums, groups: tuple[str, str], *, with_p: bool
) -> tuple[dict[str, Any], str]:
    found = adjusted(one.both, other.both)
    text = two.of_difference(two.ADJUSTED, found.test, groups, with_p=with_p)
    return {"slope": found.slope, **asdict(found.test)}, text


def _welch(
    what: str, spreads: list[Spread], groups: tuple[str, str], *, with_p: bool
) -> tuple[dict[str, Any], str]:
    test: TTest = welch(*spreads)
    return asdict(test), two.of_difference(what, test, groups, with_p=with_p)


def _paper_z(gains: list[Spread]) -> tuple[dict[str, float], str]:
    found = paper_z(*gains)
    return asdict(found), two.of_paper_z(found.z)


def _between(gains: list[Spread]) -> tuple[float, str]:
    d = cohen_d(*gains)
    return d, say.of_effect(d, say.D_BETWEEN)


def only_after_table(
    form: str, spreads: list[Spread], groups: tuple[str, str], *, classes: int
) -> dict[str, Any]:
    """Two groups on a form that has no earlier one to compare with. Needs scipy."""
    told = Told()
    told.tell("welch", lambda: _welch(said("Form {form}", form=form), spreads, groups,
                                       with_p=classes > 1))  # fmt: skip
    told.tell("paper_z", lambda: _paper_z_of(spreads))
    return {"form": form, **told.numbers, "sentences": told.sentences, "refusals": told.refusals}


def _paper_z_of(spreads: list[Spread]) -> tuple[dict[str, float], str]:
    for group in spreads:
        at_least(group.n, FEWEST)
    return asdict(paper_z(*spreads)), ""
