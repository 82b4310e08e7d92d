"""A report on a class as text for the terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

from sim.classroom.report.items.second_thoughts import thoughts
from sim.classroom.report.items.typed_numbers import typed_sentence
from sim.classroom.report.numerals import mean_and_sd
from sim.classroom.report.sentences import FEW_QUESTIONS, left_open, of_files, unmarked, waiting
from sim.classroom.show.own_runs import own_run_sentence
from sim.classroom.show.predictions import again_sentence
from sim.classroom.show.report_page import beside, of_group
from sim.cli.tables import table
from sim.scene.notation import number
from sim.scene.said import commas, counted, in_words, said, template

Tell = Callable[[str], str]
"""A sentence in the language of the report, safe for a terminal."""

MEANS = (
    template("form"), template("group"), template("students"), template("mean"), template("sd"),
    template("marks"),
)  # fmt: skip
ITEMS = (
    template("question"), template("answered right"), template("partly right"), template("wrong"),
    template("left open"), template("to read"), template("difficulty"), template("discr."), "r",
    template("chosen"),
)  # fmt: skip
TOPICS = (
    template("topic"), template("questions"), template("group"), template("took both"),
    template("before"), template("after"), template("gain g"),
)  # fmt: skip
MOST_FILES = 8
"""Files beside a question to the teacher."""


def report_as_text(report: Mapping[str, Any], words: Mapping[str, str]) -> str:
    """What `carts class` prints for people: counts, questions, means, gains, items.

    `words`: each English sentence in the language; empty for English.
    """
    return "\n\n".join(part for part in _parts(report, teller(words)) if part)


def teller(words: Mapping[str, str]) -> Tell:
    """`words`: each English sentence in the language; empty for English."""
    return lambda sentence: _safe(in_words(sentence, words))


def _parts(report: Mapping[str, Any], tell: Tell) -> Iterator[str]:
    yield tell(of_files(report["files"]))
    yield "\n".join(
        f"? {tell(f['sentence'])}\n  {', '.join(map(tell, f['files'][:MOST_FILES]))}"
        for f in report["flags"]
    )
    for lesson in report["lessons"]:
        yield from _lesson(lesson, report, tell)
    yield _lines([*report["notes"], *_options(report)], tell)


def _options(report: Mapping[str, Any]) -> Iterator[str]:
    """What an option of the command can tell, beside a note that says where a table can."""
    forms = (form for lesson in report["lessons"] for form in lesson["forms"])
    if report["files"].get("unit") == "rows" and any(form["of"] is None for form in forms):
        yield template("--max N tells the most marks too.")


def _lesson(lesson: Mapping[str, Any], report: Mapping[str, Any], tell: Tell) -> Iterator[str]:
    title = _safe(lesson["title"])
    yield f"{title}\n{'=' * len(title)}"
    yield _means(lesson, tell)
    says: list[str] = [
        said("{name}: {says}", name=commas([f["form"], g["group"]]), says=g["sentence"])
        for f in lesson["forms"] for g in f["groups"] if "sentence" in g
    ]  # fmt: skip
    says += [of_group(form["form"], left) for form in lesson["forms"]
             if form["of"] is not None and (left := left_open(form["items"]))]  # fmt: skip
    name_it = template("Name the key file too: --key FILE")
    says += [unmarked(form["form"], lesson["lesson"], report, name_it=name_it)
             for form in lesson["forms"] if not form["has_key"]]  # fmt: skip
    says += [waiting(form) for form in lesson["forms"] if form["has_key"] and form["unread"]]
    yield _lines(says, tell)
    if lesson["comparison"]:
        yield _lines([*lesson["comparison"]["sentences"], *lesson["comparison"]["refusals"]], tell)
    for row in lesson.get("comparisons", []):
        yield f"{tell(beside(row))}:"
        yield _lines([*row["sentences"], *row["refusals"]], tell)
    for row in lesson["gains"]:
        yield tell(said("Before and after, {group}:", group=row["group"]))
        yield _lines([*row["sentences"], *row["refusals"]], tell)
    yield _topics(lesson, tell)
    for row in lesson["later"]:
        title = tell(said("Form {form}", form=row["form"]))
        yield f"{title}:\n{_lines([*row['sentences'], *row['refusals']], tell)}"
    for form in lesson["forms"]:
        yield _items(form, tell)


def _lines(sentences: Sequence[str], tell: Tell) -> str:
    return "\n".join(f"- {tell(sentence)}" for sentence in sentences)


def _means(lesson: Mapping[str, Any], tell: Tell) -> str:
    rows = [
        (tell(form["form"]), tell(group["group"]), str(group["n"]), number(group["mean"]),
         number(group["sd"]), "–" if form["of"] is None else str(form["of"]))
        for form in lesson["forms"]
        for group in form["groups"]
        if "mean" in group
    ]  # fmt: skip
    return table(tuple(map(tell, MEANS)), rows) if rows else ""


def _topics(lesson: Mapping[str, Any], tell: Tell) -> str:
    """Gains topic by topic, and by how much two groups differ in each."""
    rows = [
        (
            _safe(row["topic"]), str(row["questions"]), tell(row["group"]), str(row["n"]),
            mean_and_sd(row["pre"]), mean_and_sd(row["post"]),
            "–" if row["gain"] is None else number(row["gain"]),
        )
        for row in lesson["topics"]
    ]  # fmt: skip
    if not rows:
        return ""
    says = [*(row["sentence"] for row in lesson["topic_differences"]), FEW_QUESTIONS]
    title = tell(template("By topic"))
    return f"{title}:\n{table(tuple(map(tell, TOPICS)), rows)}\n{_lines(says, tell)}"


def _items(form: Mapping[str, Any], tell: Tell) -> str:
    rows = [
        (
            item["id"],
            *(str(item[name]) for name in ("right", "partly", "wrong", "empty", "unread")),
            *("–" if item[name] is None else number(item[name])
              for name in ("difficulty", "discrimination", "point_biserial")),
            " ".join(f"{c['option']}{'*' if c.get('correct') else ''}:{c['count']}"
                     for c in item["choices"] if c["count"] or len(c["option"]) == 1),
        )
        for item in form["items"]
    ]  # fmt: skip
    title = tell(said("Form {form}", form=form["form"]))
    made = f"{title}:\n{table(tuple(map(tell, ITEMS)), rows)}" if rows else ""
    talk = _lines([row["sentence"] for row in form["talk"]], tell)
    parts = [
        made or (f"{title}:" if form["sentences"] else ""),
        _lines(form["sentences"], tell),
        _lines(
            [
                said("{name}: {says}", name=item["label"], says=says)
                for item in form["items"]
                for says in (typed_sentence(item), *thoughts(item))
                if says
            ],
            tell,
        ),
        _lines([row["sentence"] for row in form["beliefs"]], tell),
        f"{tell(template('What to talk about first'))}:\n{talk}" if talk else "",
    ]
    parts += map(partial(_prediction, tell=tell), form["predictions"])
    parts += map(partial(_own_runs, tell=tell), form["own_runs"])
    return "\n".join(part for part in parts if part)


def _prediction(row: Mapping[str, Any], tell: Tell) -> str:
    """How many predicted what; of drawn curves only how many there are."""
    says = list(map(_counted, row["answers"]))
    if row["curves"]:
        says.append(counted("1 curve (see the report that --html writes)",
                            "{n} curves (see the report that --html writes)",
                            n=len(row["curves"])))  # fmt: skip
    if row["more"]:
        says.append(said("and {n} more", n=f"{row['more']}"))
    if row["reasons"]:
        says.append(said("{n} gave a reason (--json)", n=f"{len(row['reasons'])}"))
    if again := again_sentence(row):
        says.append(again)
    title = tell(said("Predicted, {scene}", scene=row["ask"] or row["id"]))
    return f"{title}\n{_lines(says, tell)}"


def _own_runs(row: Mapping[str, Any], tell: Tell) -> str:
    """What was done with runs of their own."""
    says = [own_run_sentence(row), *map(_counted, row["said"])]
    title = tell(said("Tried, {scene}", scene=row["ask"] or row["id"]))
    return f"{title}\n{_lines(says, tell)}"


def _counted(one: Mapping[str, Any]) -> str:
    return said("{count} × {says}", count=f"{one['count']}", says=one["said"])


def _safe(text: object) -> str:
    """No control character of a file reaches the terminal."""
    return "".join(c if c.isprintable() else "·" for c in str(text))
