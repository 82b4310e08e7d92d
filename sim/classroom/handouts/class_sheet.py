"""The page of a class: what to talk about first, every question, beliefs, predictions. No names.

It is made from the report, so that its numbers are those of the report, and may hang on a wall: no
student stands in it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sim.classroom.handouts.belief_map import belief_map
from sim.classroom.handouts.wording import FORMS, cut
from sim.classroom.report.numerals import numbers, students
from sim.classroom.report.sentences import left_open
from sim.classroom.show.html_parts import Tell, table, text
from sim.scene.notation import number
from sim.scene.said import Said, counted, said, template

Row = Mapping[str, Any]
SHADES = 4
"""Steps of grey in the map: paper shows no more."""

MOST_SAID = 4
BRIEF = 60
"""Characters of an option beside its question."""
SHORT = 130
"""Characters of a question or an answer: two lines of the table. Nearly all are told whole."""

VERDICTS = {
    "right": template("answered right"),
    "partly": template("partly right"),
    "wrong": template("wrong"),
    "empty": template("left open"),
}


def sheet_html(report: Row, tell: Tell) -> str:
    """A page for each form of each lesson."""
    pages = [
        _page(lesson, form, tell)
        for lesson in report["lessons"]
        for form in lesson["forms"]
        if form["n"]
    ]
    return f'<div class="carts-sheets">{"".join(pages)}</div>'


def _page(lesson: Row, form: Row, tell: Tell) -> str:
    name = f"{text(lesson['title'])} · {tell(FORMS[form['form']])}"
    head = f"<header><h2>{name}</h2><span>{tell(students(form['n']))}</span></header>"
    return f'<section class="carts-sheet">{head}{"".join(_parts(form, tell))}</section>'


def _parts(form: Row, tell: Tell) -> Iterator[str]:
    if not form["has_key"]:
        yield f"<p>{tell(template('These answers were not marked.'))}</p>"
    means = [group for group in form["groups"] if "mean" in group]
    if means:
        said_ = (
            said("{group}: {mean} of {of} marks on average", group=one["group"],
                 mean=number(one["mean"]), of=str(form["of"])) if len(form["groups"]) > 1
            else said("{mean} of {of} marks on average", mean=number(one["mean"]),
                      of=str(form["of"]))
            for one in means
        )  # fmt: skip
        told = [*said_, *filter(None, [left_open(form["items"])])]
        yield f"<p>{'<br>'.join(map(tell, told))}</p>"
    if other := sum(bool(one["foreign"]) for one in form["students"]):
        yield f"<p>{tell(_without_total(other))}</p>"
    if form["talk"]:
        rows = "".join(f"<li>{tell(row['sentence'])}</li>" for row in form["talk"])
        yield f"<h3>{tell(template('What to talk about first'))}</h3><ol>{rows}</ol>"
    asked = [(k, item) for k, item in enumerate(form["items"], 1) if item["n"] and item["worth"]]
    items = [(k, item) for k, item in asked if not item["unread"]]
    if items:
        yield f"<h3>{tell(template('Question by question'))}</h3>{_questions(items, tell)}"
    if unread := [k for k, item in enumerate(form["items"], 1) if item["unread"]]:
        reads = said("To be read by you: {questions}", questions=numbers(unread))
        yield f"<p>{tell(reads)}</p>"
    yield _map(items, tell)
    yield _counted(template("First ideas"), _ideas(form["items"]), tell)
    before = template("Predicted before the run")
    yield _counted(before, _predictions(form["predictions"]), tell)


def _without_total(n: int) -> str:
    return counted(
        "1 student had another text of some questions: no total, and these answers do not count.",
        "{n} students had another text of some questions: no totals, and these answers do not "
        "count.",
        n=n,
    )


def _questions(items: Sequence[tuple[int, Row]], tell: Tell) -> str:
    """A bar for each question, and the wrong answer that was chosen most."""
    asked = any(item["sure"] for _, item in items)
    rows = []
    for k, item in items:
        wrong = [c for c in item["choices"] if not c.get("correct") and c["count"] > 1]
        most = max(wrong, key=lambda c: int(c["count"]), default=None)
        chosen = f"{tell(_option(most))} ({most['count']})" if most else ""
        sure = f"{item['sure']['wrong']}" if item["sure"] else "–"
        rows.append([str(k), text(cut(item["ask"], SHORT)), _bar(item, tell),
                     str(item["right"]), *([sure] if asked else []), chosen])  # fmt: skip
    certain = [tell(template("sure and wrong"))] if asked else []
    head = ["", "", "", tell(VERDICTS["right"]), *certain, tell(template("chosen most, wrong"))]
    key = "".join(
        f'<span><i class="carts-sheet-{name}"></i>{tell(words)}</span>'
        for name, words in VERDICTS.items()
        if any(item[name] for _, item in items)
    )
    return f'{table(head, rows, kind="sheet")}<p class="carts-sheet-key">{key}</p>'


def _option(choice: Row) -> str:
    """Its letter and how it begins."""
    return f"{choice['label']}: {cut(choice['text'], BRIEF)}" if choice["text"] else choice["label"]


def _bar(item: Row, tell: Tell) -> str:
    """How all answers divide, as a drawing that says its numbers."""
    whole = sum(item[name] for name in VERDICTS) or 1
    parts, x = [], 0.0
    for name in VERDICTS:
        width = 100 * item[name] / whole
        if width:
            parts.append(f'<rect class="carts-sheet-{name}" x="{x:.2f}" width="{width:.2f}"'
                         ' height="10"/>')  # fmt: skip
        x += width
    told = ", ".join(f"{tell(words)} {item[name]}" for name, words in VERDICTS.items()
                     if item[name])  # fmt: skip
    return (
        f'<svg class="carts-sheet-bar" viewBox="0 0 100 10" preserveAspectRatio="none" role="img" '
        f'aria-label="{told}">{"".join(parts)}</svg>'
    )


def _map(items: Sequence[tuple[int, Row]], tell: Tell) -> str:
    """Beliefs by question, darker where more chose them."""
    found = belief_map(items)
    if not found.rows:
        return ""
    most = max(count or 0 for _, row in found.rows for count in row)
    head = "".join(f'<th scope="col">{k}</th>' for k in found.questions)
    body = "".join(
        f'<tr><th scope="row">{tell(says)}</th>{"".join(_cell(count, most) for count in row)}</tr>'
        for says, row in found.rows
    )
    return (
        f"<h3>{tell(template('What students often think'))}</h3>"
        f'<table class="carts-sheet-map"><thead><tr><td></td>{head}</tr></thead>'
        f"<tbody>{body}</tbody></table>"
        f'<p class="carts-class-quiet">{tell(MAP_SAYS)}</p>'
    )


MAP_SAYS = template(
    "Numbers say how many students chose an answer that goes with the belief. One answer is no "
    "diagnosis: look for rows with several numbers."
)


def _cell(count: int | None, most: int) -> str:
    if count is None:
        return "<td></td>"
    shade = -(-SHADES * count // most) if count else 0
    return f'<td class="carts-shade-{shade}">{count}</td>'


def _ideas(items: Sequence[Row]) -> list[tuple[str, list[tuple[str, int]]]]:
    """First ideas by their question: nothing is right or wrong in them."""
    return [
        (item["ask"], [(c["text"] or c["label"], int(c["count"])) for c in item["choices"]])
        for item in items
        if item["type"] == "idea"
    ]


def _predictions(rows: Sequence[Row]) -> list[tuple[str, list[tuple[str, int]]]]:
    """What was expected most, scene by scene."""
    return [
        (row["ask"] or row["id"], [(one["said"], int(one["count"])) for one in row["answers"]])
        for row in rows
    ]


def _counted(title: str, rows: Sequence[tuple[str, list[tuple[str, int]]]], tell: Tell) -> str:
    """What was said most often, question by question; nothing where nothing was said."""
    lines = []
    for ask, answers in rows:
        most = sorted((one for one in answers if one[1]), key=lambda one: -one[1])[:MOST_SAID]
        if most:
            told = "; ".join(f"{_words(words, tell)} ({count})" for words, count in most)
            lines.append(f"<li>{text(cut(ask, SHORT))}<br>{told}</li>")
    return f"<h3>{tell(title)}</h3><ul>{''.join(lines)}</ul>" if lines else ""


def _words(words: str, tell: Tell) -> str:
    """What we say in full, what a student said cut to its beginning."""
    return tell(words) if isinstance(words, Said) else text(cut(words, SHORT))
