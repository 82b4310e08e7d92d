"""The questions of a form as HTML: an overview, each one with its answers, who left what open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.report.sentences import number, signed
from sim.classroom.show.html_parts import listed, table, text, who
from sim.classroom.show.own_runs import own_runs_html
from sim.classroom.show.predictions import predictions_html
from sim.classroom.show.prose import prose

Row = Mapping[str, Any]
TITLES = {"pre": "before (pre)", "post": "after (post)", "delayed": "later (delayed)",
          "worksheet": "worksheet"}  # fmt: skip


def form_html(form: Row) -> str:
    """What a class answered in one form."""
    title = text(TITLES.get(form["form"], form["form"]))
    items = [item for item in form["items"] if item["n"]]
    parts = [f"<h3>Form {title}: questions</h3>"]
    if form["talk"]:
        parts.append("<h4>What to talk about first</h4>")
        parts.append(listed((row["sentence"] for row in form["talk"]), "talk"))
    parts.append(_overview(items))
    parts.append(listed(form["sentences"]))
    if form["beliefs"]:
        parts.append("<h4>Beliefs behind two answers or more of a student</h4>")
        parts.append(listed(row["sentence"] for row in form["beliefs"]))
    each = "".join(map(_item, items))
    if items:
        parts.append(
            f"<details><summary>Question by question: form {title}</summary>{each}</details>"
        )
    parts.append(predictions_html(form["predictions"]))
    parts.append(own_runs_html(form["own_runs"]))
    parts.append(_students(form))
    return "".join(parts)


def _overview(items: Sequence[Row]) -> str:
    """One line for each question, with the wrong answer that was chosen most."""
    rows = []
    for item in items:
        wrong = [c for c in item["choices"] if not c.get("correct") and c["count"] > 1]
        most = max(wrong, key=lambda c: c["count"], default=None) if item["worth"] else None
        chosen = f"{most['label']} ({most['count']})" if most else ""
        sure = f"{item['sure']['right']} / {item['sure']['wrong']}" if item["sure"] else "–"
        right = f"{item['right']} of {item['n']}" if item["worth"] else "–"
        if item.get("optional"):
            right = f"{item['right']} of {item['answered']}, optional"
        if item["unread"]:
            right = f"{item['unread']} to read"
        numbers = ("difficulty", "discrimination", "point_biserial")
        rows.append([
            text(item["label"]), right, str(item["empty"]), sure,
            *("–" if item[n] is None else number(item[n]) for n in numbers),
            text(chosen), text(most.get("says", "") if most else ""),
        ])  # fmt: skip
    head = ["question", "right", "open", "sure: right / wrong", "difficulty", "discrimination", "r",
            "chosen most, wrong", "students who choose it often think"]  # fmt: skip
    return table(head, rows, kind="overview") if rows else ""


def _item(item: Row) -> str:
    quiet = f" <small>{text(item['id'])}</small>" if item["label"] != item["id"] else ""
    title = f"<h4>{text(item['label'])}{quiet}</h4>"
    title += f'<p class="carts-class-ask">{text(prose(item["ask"]))}</p>'
    rows = [
        [
            f"{text(choice['label'])}{' ✓' if choice.get('correct') else ''}",
            text(prose(choice["text"])),
            str(choice["count"]),
            text(choice.get("says", "")),
        ]
        for choice in item["choices"]
    ]
    head = ["letter", "answer", "chosen", "students who choose it often think"]
    facts = [item["sentence"], *item["notes"]]
    if item["point_biserial"] is not None:
        facts.append(
            f"Correlation with the other questions, rough: {signed(item['point_biserial'])}."
        )
    made = table(head, rows, kind="item") if rows else ""
    return f'<div class="carts-class-item">{title}{made}{listed(facts)}</div>'


def _students(form: Row) -> str:
    rows = [
        [
            who(row["student"]), who(row["group"]),
            "–" if row["total"] is None else f"{row['total']}",
            text(", ".join(row["open"])) or "–", text(", ".join(row["waiting"])) or "–",
            who(row["file"]),
        ]
        for row in form["students"]
    ]  # fmt: skip
    head = [
        "code word",
        "group",
        "marks" if form["of"] is None else f"marks of {form['of']}",
        "left open",
        "to be read",
        "file",
    ]
    title = f"Who left what open: form {text(form['form'])}"
    return f"<details><summary>{title}</summary>{table(head, rows, kind='students')}</details>"
