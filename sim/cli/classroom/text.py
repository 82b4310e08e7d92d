"""A report on a class as text for the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from sim.classroom.report.sentences import files_read, number, unmarked
from sim.classroom.show.own_runs import own_run_sentence
from sim.cli.tables import table


def report_as_text(report: Mapping[str, Any]) -> str:
    """What `carts class` prints for people: counts, questions, means, gains, items."""
    return "\n\n".join(part for part in _parts(report) if part)


def _parts(report: Mapping[str, Any]) -> Iterator[str]:
    files = report["files"]
    yield f"{files['counted']} of {files['read']} {files_read(files)} are counted."
    yield "\n".join(f"? {_safe(f['sentence'])}\n  {', '.join(f['files'][:8])}"
                    for f in report["flags"])  # fmt: skip
    for lesson in report["lessons"]:
        title = _safe(lesson["title"])
        yield f"{title}\n{'=' * len(title)}"
        yield _means(lesson)
        says = [g["sentence"] for f in lesson["forms"] for g in f["groups"] if "sentence" in g]
        says += [
            f"{unmarked(form['form'])} Name the key file too: --key FILE"
            for form in lesson["forms"]
            if not form["has_key"]
        ]
        yield _lines(says)
        if lesson["comparison"]:
            yield _lines([*lesson["comparison"]["sentences"], *lesson["comparison"]["refusals"]])
        for row in lesson.get("comparisons", []):
            first, second = map(_safe, row["groups"])
            yield f"{first} beside {second}:"
            yield _lines([*row["sentences"], *row["refusals"]])
        for row in lesson["gains"]:
            yield f"Before and after, {_safe(row['group'])}:"
            yield _lines([*row["sentences"], *row["refusals"]])
        for form in lesson["forms"]:
            yield _items(form)
    yield _lines(report["notes"])


def _lines(sentences: list[str]) -> str:
    return "\n".join(f"- {_safe(sentence)}" for sentence in sentences)


def _means(lesson: Mapping[str, Any]) -> str:
    rows = [
        (form["form"], _safe(group["group"]), str(group["n"]), number(group["mean"]),
         number(group["sd"]), "–" if form["of"] is None else str(form["of"]))
        for form in lesson["forms"]
        for group in form["groups"]
        if "mean" in group
    ]  # fmt: skip
    return table(("form", "group", "students", "mean", "sd", "of"), rows) if rows else ""


def _items(form: Mapping[str, Any]) -> str:
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
    head = (
        "item",
        "right",
        "partly",
        "wrong",
        "open",
        "to read",
        "difficulty",
        "discr.",
        "r",
        "chosen",
    )
    whole = _lines(form["sentences"])
    made = f"Form {form['form']}:\n{table(head, rows)}" if rows else ""
    beliefs = _lines([row["sentence"] for row in form["beliefs"]])
    talk = _lines([row["sentence"] for row in form["talk"]])
    parts = [made, whole, beliefs, f"What to talk about first:\n{talk}" if talk else ""]
    parts += [_prediction(row) for row in form["predictions"]]
    parts += [_own_runs(row) for row in form["own_runs"]]
    return "\n".join(part for part in parts if part)


def _prediction(row: Mapping[str, Any]) -> str:
    """How many predicted what; of drawn curves only how many there are."""
    said = [f"{one['count']} × {_safe(one['said'])}" for one in row["answers"]]
    said += [f"{len(row['curves'])} curves (see the report that --html writes)"] * bool(
        row["curves"]
    )
    said += [f"and {row['more']} more"] if row["more"] else []
    said += [f"{len(row['reasons'])} gave a reason (--json)"] if row["reasons"] else []
    return f"Predicted, {_safe(row['ask'] or row['id'])}\n{_lines(said)}"


def _own_runs(row: Mapping[str, Any]) -> str:
    """What was done with runs of their own."""
    said = [f"{one['count']} × {_safe(one['said'])}" for one in row["said"]]
    told = [own_run_sentence(row), *said]
    return f"Tried, {_safe(row['ask'] or row['id'])}\n{_lines(told)}"


def _safe(text: object) -> str:
    """No control character of a file reaches the terminal."""
    return "".join(c if c.isprintable() else "·" for c in str(text))
