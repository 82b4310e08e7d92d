"""What the numbers of a class say, in plain words: with every number a sentence.

Intervals come before p; p is never called the chance that teaching worked; what could not be told
is not said to be equal.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from sim.classroom.report.numerals import signed, students
from sim.classroom.statistics.compare import TTest
from sim.classroom.statistics.gain import EDGE
from sim.classroom.statistics.ranks import SignedRanks
from sim.classroom.statistics.spread import Spread
from sim.scene.notation import number
from sim.scene.said import commas, counted, joined, listed, said, template

ONE_ITEM = template(
    "One item is no diagnosis. The tables say which answers were chosen, and what students who "
    "choose them often think."
)
NO_MOST = template("the most marks of this test are not known")
NO_ITEMS = template("it needs the marks of each question")
NO_LEVELS = template("the answers of strong and of weak students apart were not handed on")
FEW_QUESTIONS = template(
    "A topic has few questions. That one topic gained more than another does not show that they "
    "differ: that needs its own test."
)
SAME_FORM = template("The same questions were asked twice: part of the gain may be memory.")
D_WITHIN = template("the gain divided by √((s₁² + s₂²)/2) of the two tests")
D_BETWEEN = template("the difference of the mean gains divided by their pooled standard deviation")
TITLES = {
    "pre": template("before (pre)"),
    "post": template("after (post)"),
    "delayed": template("later (delayed)"),
    "worksheet": template("worksheet"),
}
"""What a form is called where it has a line of its own."""

COUNTED = {
    "files": (template("No file of answers was found."),
              template("{counted} of {read} files of answers are counted.")),
    "rows": (template("No row of a table was found."),
             template("{counted} of {read} rows of the table are counted.")),
    "summaries": (template("No summary was found."),
                  template("{counted} of {read} summaries are counted.")),
}  # fmt: skip


def within_marks(low: float, high: float, of: float | None) -> tuple[float, float]:
    """An interval without what no mark can be: below nought, or above all there are."""
    return max(0.0, low), min(high, math.inf if of is None else of)


def begins(words: str, most: int) -> str:
    """The beginning of a text, up to the end of a word; a text of `most` characters is whole."""
    return words if len(words) <= most else f"{words[:most].rsplit(' ', 1)[0]} …"


def of_files(files: Mapping[str, Any]) -> str:
    """What a report counts: files of answers, rows of a table, or summaries of schools."""
    nothing, some = COUNTED[files.get("unit", "files")]
    if not files["read"]:
        return nothing
    return said(some, counted=f"{files['counted']}", read=f"{files['read']}")


def left_open(items: Iterable[Mapping[str, Any]]) -> str:
    """How much of what gives marks nobody answered; "" where all did."""
    asked = [item for item in items if item["worth"] and not item.get("optional")]
    empty, whole = sum(item["empty"] for item in asked), sum(item["n"] for item in asked)
    if not empty:
        return ""
    return counted(
        "1 of {all} answers was left open: it gives no marks.",
        "{n} of {all} answers were left open: they give no marks.",
        n=empty, all=f"{whole:,}",
    )  # fmt: skip


def unmarked(form: str, lesson: str, report: Mapping[str, Any], *, name_it: str) -> str:
    """That a form's key is missing, and where it can come from; `name_it`: how files of answers get
    one, where the report is shown. To a summary no key can be added any more."""
    missing = said("Form {form}: there is no key for it, so nothing is marked.", form=form)
    unit = report["files"].get("unit", "files")
    if unit == "rows":
        return joined(missing, template("A row KEY in the table gives the right answers."))
    if unit != "files":
        return missing
    name = said("It is called {name}.", name=f"{lesson}.key.json")
    tests = [key for key in report["keys"] if not key.endswith(" worksheet")]
    there = said("The keys that are here are for {keys}.", keys=listed(tests)) if tests else ""
    return joined(missing, name_it, name, there)


def waiting(form: Mapping[str, Any]) -> str:
    """Answers in words that nobody has marked yet."""
    labels = {item["id"]: item["label"] for item in form["items"]}
    questions = commas([label for name, label in labels.items() if name in form["unread"]])
    return said("Form {form}, to be read by you and in no total yet: {questions}.",
                form=form["form"], questions=questions)  # fmt: skip


def too_few(n: int, fewest: int) -> str:
    """A group of which only the marks are listed."""
    return said("{students}: no statistics for fewer than {fewest}.", students=students(n),
                fewest=f"{fewest}")  # fmt: skip


def too_few_pairs(n: int, fewest: int) -> str:
    """The same of those who took both tests."""
    return counted("1 student took both tests: no statistics for fewer than {fewest}.",
                   "{n} students took both tests: no statistics for fewer than {fewest}.",
                   n=n, fewest=f"{fewest}")  # fmt: skip


def of_p(p: float) -> str:
    """What a p-value is, and what it is not."""
    return said(
        "If teaching made no difference, a gap this big or bigger would turn up in {share} such "
        "studies ({p}). This is not the chance that teaching worked.",
        share=out_of(p), p=_p(p),
    )  # fmt: skip


def out_of(p: float) -> str:
    """How often a p-value means: in about 3 of 100."""
    if p < 0.0005:
        return said("fewer than 1 of 1,000")
    if p < 0.0095:
        return said("about {n} of 1,000", n=f"{round(1000 * p)}")
    return said("about {n} of 100", n=f"{round(100 * p)}")


def _p(p: float) -> str:
    return "p < 0.001" if p < 0.001 else f"p = {p:.3f}" if p < 0.1 else f"p = {p:.2f}"


def of_mean(spread: Spread, of: float | None, interval: tuple[float, float] | None) -> str:
    """A class on a test."""
    values = {"students": students(spread.n), "mean": number(spread.mean), "sd": number(spread.sd)}
    text = (
        said("{students}: {mean} marks on average, with a standard deviation of {sd}.", **values)
        if of is None
        else said("{students}: {mean} of {of} marks on average, with a standard deviation of {sd}.",
                  of=f"{of:g}", **values)
    )  # fmt: skip
    if interval is None:
        return text
    low, high = within_marks(*interval, of)
    return joined(text, said(
        "For many students like these the average would lie between about {low} and {high} "
        "(95 % interval).",
        low=number(low), high=number(high),
    ))  # fmt: skip


def of_gain(gain: float, before: Spread, after: Spread, of: float) -> str:
    """Hake's gain of a class."""
    start = said(
        "The average went from {before} to {after} of {of} marks in the {n} students who took both "
        "tests.",
        before=number(before.mean), after=number(after.mean), of=f"{of:g}", n=f"{before.n}",
    )  # fmt: skip
    if gain < 0:
        return joined(start, said("The class lost marks: g = {gain}.", gain=number(gain)))
    return joined(start, said(
        "Of the marks that the class could still gain it gained {percent} % (Hake's gain g = "
        "{gain}). This is a number for the class, never for a student.",
        percent=f"{100 * gain:.0f}", gain=number(gain),
    ))  # fmt: skip


def of_effect(d: float, definition: str) -> str:
    """Cohen's d."""
    return said("Cohen's d = {d}: {definition}.", d=signed(d), definition=definition)


def of_change(test: TTest) -> str:
    """The change within one class."""
    return joined(
        said(
            "The change is {difference} marks; anything from {low} to {high} would fit (95 % "
            "interval).",
            difference=signed(test.difference), low=signed(test.low), high=signed(test.high),
        ),
        template("The interval leaves out zero.")
        if test.low > 0 or test.high < 0
        else could_not(test),
        template("Without a second group it does not tell what caused the change."),
    )  # fmt: skip


def could_not(test: TTest) -> str:
    """No difference was seen; that does not show that there is none."""
    return said(
        "We could not tell. It does not show that there is no difference: anything from {low} to "
        "{high} marks would fit.",
        low=signed(test.low), high=signed(test.high),
    )  # fmt: skip


def of_ranks(found: SignedRanks) -> str:
    """Wilcoxon's test."""
    how = said("{p}, ties counted", p=_p(found.p)) if found.way == "counted" else _p(found.p)
    return said(
        "{up} went up, {down} went down, {same} stayed. If up and down were luck, this or more "
        "would turn up in {share} classes (Wilcoxon, {p}).",
        up=f"{found.up}", down=f"{found.down}", same=f"{found.same}", share=out_of(found.p), p=how,
    )  # fmt: skip


def of_alpha(alpha: float) -> str:
    """How far the questions of a test measure the same."""
    if alpha < 0.7:
        return said("Cronbach's alpha = {alpha}: below 0.7, so the questions measure different "
                    "things, or are too few.", alpha=number(alpha))  # fmt: skip
    return said("Cronbach's alpha = {alpha}: the questions measure much the same (0.7 is usual for "
                "groups).", alpha=number(alpha))  # fmt: skip


def of_delta(delta: float) -> str:
    """How far the totals of a test spread."""
    if delta < 0.9:
        return said("Ferguson's delta = {delta}: below 0.9, so the totals lie close together.",
                    delta=number(delta))  # fmt: skip
    return said("Ferguson's delta = {delta}: the totals spread over the whole test (0.9 is usual).",
                delta=number(delta))  # fmt: skip


def of_edges(low: float, high: float) -> str:
    """A test that was too hard or too easy to show a difference; empty if it was not."""
    hard = said("{percent} % of the students have 0 marks: the test was too hard to show all "
                "differences.", percent=f"{100 * low:.0f}")  # fmt: skip
    easy = said("{percent} % have full marks: the test was too easy to show all differences.",
                percent=f"{100 * high:.0f}")  # fmt: skip
    return joined(hard if low > EDGE else "", easy if high > EDGE else "")


def of_many(count: int) -> str:
    """A warning when many comparisons stand on one page; empty for a few."""
    if count < 10:
        return ""
    if (lucky := round(count / 20)) <= 1:
        return said("{n} comparisons: about one will look significant by luck.", n=f"{count}")
    return said("{n} comparisons: about {lucky} will look significant by luck.", n=f"{count}",
                lucky=f"{lucky}")  # fmt: skip
