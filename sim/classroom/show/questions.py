"""The questions of a form as HTML: an overview, each one with its answers, who left what open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.report.items.second_thoughts import thoughts
from sim.classroom.report.items.typed_numbers import typed_sentence
from sim.classroom.report.numerals import signed
from sim.classroom.report.sentences import TITLES
from sim.classroom.show.html_parts import Tell, listed, person, table, text
from sim.classroom.show.numbered import numbering
from sim.classroom.show.own_runs import own_runs_html
from sim.classroom.show.predictions import predictions_html
from sim.classroom.show.prose import prose
from sim.scene.notation import number
from sim.scene.said import said, template

Row = Mapping[str, Any]
TOGETHER = template("How well these questions measure one thing together")
OFTEN_THINK = template("students who choose it often think")


def form_html(form: Row, tell: Tell) -> str:
    """What a class answered in one form."""
    title = TITLES.get(form["form"], str(form["form"]))
    items = [item for item in form["items"] if item["n"]]
    parts = [f"<h3>{tell(said('Form {form}: questions', form=title))}</h3>"]
    if form["talk"]:
        parts.append(f"<h4>{tell(template('What to talk about first'))}</h4>")
        parts.append(listed((row["sentence"] for row in form["talk"]), tell, "talk"))
    parts.append(_overview(items, tell))
    if form["sentences"]:
        parts.append(f"<details><summary>{tell(TOGETHER)}</summary>"
                     f"{listed(form['sentences'], tell)}</details>")  # fmt: skip
    if form["beliefs"]:
        beliefs = template("Beliefs behind two answers or more of a student")
        parts.append(f"<h4>{tell(beliefs)}</h4>")
        parts.append(listed((row["sentence"] for row in form["beliefs"]), tell))
    if items:
        each = "".join(_item(item, tell) for item in items)
        summary = tell(said("Question by question: form {form}", form=title))
        parts.append(f"<details><summary>{summary}</summary>{each}</details>")
    parts.append(predictions_html(form["predictions"], tell))
    parts.append(own_runs_html(form["own_runs"], tell))
    parts.append(_students(form, tell))
    return "".join(parts)


def _overview(items: Sequence[Row], tell: Tell) -> str:
    """One line for each question, with the wrong answer that was chosen most."""
    rows = []
    for item in items:
        wrong = [c for c in item["choices"] if not c.get("correct") and c["count"] > 1]
        most = max(wrong, key=lambda c: c["count"], default=None) if item["worth"] else None
        chosen = f"{tell(most['label'])} ({most['count']})" if most else ""
        numbers = ("difficulty", "discrimination", "point_biserial")
        rows.append([
            tell(item["label"]), tell(_right(item)),
            "–" if item.get("optional") else str(item["empty"]), tell(_sure(item)),
            *("–" if item[n] is None else number(item[n]) for n in numbers),
            chosen, tell(most.get("says", "") if most else ""),
        ])  # fmt: skip
    return table(list(map(tell, OVERVIEW)), rows, kind="overview") if rows else ""


OVERVIEW = (
    template("question"), template("answered right"), template("left open"),
    template("sure: right / wrong"), template("difficulty"), template("discrimination"), "r",
    template("chosen most, wrong"), OFTEN_THINK,
)  # fmt: skip


def _sure(item: Row) -> str:
    """How many were sure; of what is neither right nor wrong as one number."""
    if not item["sure"]:
        return "–"
    if item["worth"]:
        return f"{item['sure']['right']} / {item['sure']['wrong']}"
    return said("{n} in all", n=f"{sum(choice['sure'] for choice in item['choices'])}")


def _right(item: Row) -> str:
    """How many answered it right, or what else there is to say of it."""
    if item["unread"]:
        return said("{n} to read", n=f"{item['unread']}")
    if item.get("optional"):
        return said("{right} of {n}, optional", right=f"{item['right']}", n=f"{item['answered']}")
    if item["worth"]:
        return said("{right} of {n}", right=f"{item['right']}", n=f"{item['n']}")
    return "–"


def _item(item: Row, tell: Tell) -> str:
    quiet = f" <small>{text(item['id'])}</small>" if item["label"] != item["id"] else ""
    title = f"<h4>{tell(item['label'])}{quiet}</h4>"
    title += f'<p class="carts-class-ask">{text(prose(item["ask"]))}</p>'
    rows = [
        [
            f"{tell(choice['label'])}{' ✓' if choice.get('correct') else ''}",
            text(prose(choice["text"])),
            str(choice["count"]),
            tell(choice.get("says", "")),
        ]
        for choice in item["choices"]
    ]
    head = [template("letter"), template("answer"), template("chosen"), OFTEN_THINK]
    facts = [item["sentence"], typed_sentence(item), *thoughts(item), *item["notes"]]
    if item["point_biserial"] is not None:
        facts.append(said("Correlation with the other questions, rough: {r}.",
                          r=signed(item["point_biserial"])))  # fmt: skip
    made = table(list(map(tell, head)), rows, kind="item") if rows else ""
    return f'<div class="carts-class-item">{title}{made}{listed(facts, tell)}</div>'


def _students(form: Row, tell: Tell) -> str:
    numbers = numbering(form)

    def named(items: Sequence[str]) -> str:
        return text(", ".join(numbers(items))) or "–"

    others = any(row["foreign"] for row in form["students"])
    rows = [
        [
            person(row["student"], tell), person(row["group"], tell),
            "–" if row["total"] is None else f"{row['total']}",
            named(row["open"]), named(row["waiting"]),
            *([named(row["foreign"])] if others else []), person(row["file"], tell),
        ]
        for row in form["students"]
    ]  # fmt: skip
    marks = template("marks") if form["of"] is None else said("marks of {of}", of=f"{form['of']}")
    head = [template("code word"), template("group"), marks, template("left open"),
            template("to be read"), *([template("another text")] if others else []),
            template("file")]  # fmt: skip
    title = tell(said("Who left what open: form {form}", form=form["form"]))
    made = table(list(map(tell, head)), rows, kind="students")
    return f"<details><summary>{title}</summary>{made}</details>"
