"""What the numbers say, in plain words: with every number a sentence.

Intervals come before p; p is never called the chance that teaching worked; what could not be told
is not said to be equal.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sim.classroom.statistics.compare import PaperZ, TTest
from sim.classroom.statistics.gain import EDGE
from sim.classroom.statistics.ranks import SignedRanks
from sim.classroom.statistics.spread import Spread

ONE_CLASS = (
    "Each group is one class here. 30 students in one room are not 30 independent experiments: "
    "the real uncertainty is larger than shown, and no p-value for the teaching is given."
)
WHO_KNOWS = (
    "The table does not say which classes the groups are made of (a column “class” tells it). If "
    "each group is one class: 30 students in one room are not 30 independent experiments, and the "
    "real uncertainty is larger than shown. So no p-value is given in words."
)
ONE_ITEM = (
    "One item is no diagnosis. The tables say which answers were chosen, and what students who "
    "choose them often think."
)
NO_MOST = "the most marks of this test are not known (--max N tells them)"
NO_ITEMS = "it needs the marks of each question"
NO_LEVELS = "the answers of strong and of weak students apart were not handed on"
FEW_QUESTIONS = (
    "A topic has few questions. That one topic gained more than another does not show that they "
    "differ: that needs its own test."
)
SAME_FORM = "The same questions were asked twice: part of the gain may be memory."


def unmarked(form: str) -> str:
    """That a form's key is missing; what to do is up to who shows it."""
    return f"Form {form}: there is no key for it, so nothing is marked."


def files_read(files: Mapping[str, Any], *, one: bool = False) -> str:
    """What a report counts: files of answers, rows of a table, or summaries of schools."""
    unit = files.get("unit", "files")
    words = {
        "files": ("file of answers", "files of answers"),
        "rows": ("row of a table", "rows of the table"),
        "summaries": ("summary", "summaries"),
    }
    return words[unit][0 if one else 1]


def number(value: float, places: int = 2) -> str:
    """A number as it is written here: with a real minus, and no minus before nought."""
    text = f"{value:.{places}f}"
    return f"{0:.{places}f}" if float(text) == 0 else text.replace("-", "−")


def signed(value: float, places: int = 2) -> str:
    """The same with its sign."""
    text = number(value, places)
    return text if text.startswith("−") or float(text) == 0 else f"+{text}"


def many(count: int, one: str, more: str = "") -> str:
    """1 student, 2 students."""
    return f"{count} {one if count == 1 else more or one + 's'}"


def out_of(p: float) -> str:
    """How often a p-value means: in about 3 of 100."""
    if p < 0.0005:
        return "fewer than 1 of 1,000"
    if p < 0.0095:
        return f"about {round(1000 * p)} of 1,000"
    return f"about {round(100 * p)} of 100"


def of_p(p: float) -> str:
    """What a p-value is, and what it is not."""
    return (
        "If teaching made no difference, a gap this big or bigger would turn up in "
        f"{out_of(p)} such studies ({_p(p)}). This is not the chance that teaching worked."
    )


def _p(p: float) -> str:
    return "p < 0.001" if p < 0.001 else f"p = {p:.3f}" if p < 0.1 else f"p = {p:.2f}"


def of_mean(spread: Spread, of: float | None, interval: tuple[float, float] | None) -> str:
    """A class on a test."""
    text = (
        f"{many(spread.n, 'student')}: {number(spread.mean)}{_most(of)} marks on average, with a "
        f"standard deviation of {number(spread.sd)}."
    )
    if interval:
        low, high = max(0.0, interval[0]), min(interval[1], math.inf if of is None else of)
        text += (
            f" For many students like these the average would lie between about {number(low)} and "
            f"{number(high)} (95 % interval)."
        )
    return text


def _most(of: float | None) -> str:
    return "" if of is None else f" of {of:g}"


def of_gain(gain: float, before: Spread, after: Spread, of: float) -> str:
    """Hake's gain of a class."""
    start = (
        f"The average went from {number(before.mean)} to {number(after.mean)} of {of:g} marks in "
        f"the {before.n} students who took both tests. "
    )
    if gain < 0:
        return f"{start}The class lost marks: g = {number(gain)}."
    return (
        f"{start}Of the marks that the class could still gain it gained {100 * gain:.0f} % "
        f"(Hake's gain g = {number(gain)}). This is a number for the class, never for a student."
    )


def of_effect(d: float, definition: str) -> str:
    """Cohen's d."""
    return f"Cohen's d = {signed(d)}: {definition}."


def of_change(test: TTest) -> str:
    """The change within one class."""
    return (
        f"The change is {signed(test.difference)} marks; anything from {signed(test.low)} to "
        f"{signed(test.high)} would fit (95 % interval). "
        + ("The interval leaves out zero. " if test.low > 0 or test.high < 0 else could_not(test))
        + "Without a second group it does not tell what caused the change."
    )


def could_not(test: TTest) -> str:
    """No difference was seen; that does not show that there is none."""
    return (
        "We could not tell. It does not show that there is no difference: anything from "
        f"{signed(test.low)} to {signed(test.high)} marks would fit. "
    )


def of_ranks(found: SignedRanks) -> str:
    """Wilcoxon's test."""
    return (
        f"{found.up} went up, {found.down} went down, {found.same} stayed. If up and down were "
        f"luck, this or more would turn up in {out_of(found.p)} classes (Wilcoxon, "
        f"{_p(found.p)}{', ties counted' if found.way == 'counted' else ''})."
    )


def of_baseline(test: TTest | None, z: PaperZ, groups: tuple[str, str]) -> str:
    """Where two groups stood before anything was taught."""
    first, second = groups
    text = "Before teaching: "
    if test:
        text += (
            f"{first} minus {second} is {signed(test.difference)} marks, anything from "
            f"{signed(test.low)} to {signed(test.high)} would fit (Z = {signed(z.z)}). "
        )
    else:
        text += f"Z = {signed(z.z)}. "
    if abs(z.z) > 1:
        text += (
            "The groups started apart. A group that starts low tends to rise by itself. Read the "
            "adjusted difference first."
        )
    else:
        text += "The groups started close together."
    return text


def of_difference(what: str, test: TTest, groups: tuple[str, str], *, with_p: bool) -> str:
    """Two groups: interval first, then what it means, then perhaps p."""
    first, second = groups
    text = (
        f"{what}: {first} minus {second} is {signed(test.difference)} ± {number(test.se)} marks "
        f"(difference ± standard error); anything from {signed(test.low)} to {signed(test.high)} "
        "would fit (95 % interval). "
    )
    if test.low <= 0 <= test.high:
        text += "We could not tell: this does not show that there is no difference. "
    return (text + (of_p(test.p) if with_p else "")).strip()


def of_alpha(alpha: float) -> str:
    """How far the questions of a test measure the same."""
    text = f"Cronbach's alpha = {number(alpha)}"
    if alpha < 0.7:
        return f"{text}: below 0.7, so the questions measure different things, or are too few."
    return f"{text}: the questions measure much the same (0.7 is usual for groups)."


def of_delta(delta: float) -> str:
    """How far the totals of a test spread."""
    text = f"Ferguson's delta = {number(delta)}"
    if delta < 0.9:
        return f"{text}: below 0.9, so the totals lie close together."
    return f"{text}: the totals spread over the whole test (0.9 is usual)."


def of_classes(counts: tuple[int, int], groups: tuple[str, str], *, robust: bool) -> str:
    """What may be concluded where whole classes were taught in one way or the other."""
    made = " and ".join(
        f"“{group}” of {many(count, 'class', 'classes')}"
        for group, count in zip(groups, counts, strict=True)
    )
    text = f"The groups are made of classes: {made}. Students of one class are alike"
    if robust:
        return (
            f"{text}: read the interval that counts classes. The others are for students assigned "
            "one by one, and too narrow."
        )
    return (
        f"{text}, so the intervals are too narrow. From eight classes on, at least two in each "
        "group, an interval that counts classes is given."
    )


def of_edges(low: float, high: float) -> str:
    """A test that was too hard or too easy to show a difference; empty if it was not."""
    parts = []
    if low > EDGE:
        parts.append(f"{100 * low:.0f} % of the students have 0 marks: the test was too hard")
    if high > EDGE:
        parts.append(f"{100 * high:.0f} % have full marks: the test was too easy")
    return f"{' and '.join(parts)} to show all differences." if parts else ""


def of_many(count: int) -> str:
    """A warning when many comparisons stand on one page; empty for a few."""
    if count < 10:
        return ""
    lucky = round(count / 20)
    return (
        f"{count} comparisons: about {'one' if lucky <= 1 else lucky} will look significant by "
        "luck."
    )
