"""Predictions of a class as HTML: what was expected how often, curves over each other, reasons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.show.drawing import curves
from sim.classroom.show.html_parts import Tell, person, table, text
from sim.scene.said import counted, joined, said, template

Row = Mapping[str, Any]


def predictions_html(rows: Sequence[Row], tell: Tell) -> str:
    """All scenes that asked first; nothing where none did."""
    if not rows:
        return ""
    title = tell(template("Predicted before the run"))
    return f"<h4>{title}</h4>{''.join(_prediction(row, tell) for row in rows)}"


def _prediction(row: Row, tell: Tell) -> str:
    title = f"<h5>{text(row['ask'] or row['id'])}</h5>"
    parts = [title, f'<p class="carts-class-quiet">{tell(_how_many(row))}</p>']
    if row["curves"]:
        parts.append(f"<figure>{curves(row['curves'], tell)}</figure>")
    cells = [
        [tell(one["said"]), str(one["count"]), str(one["sure"]) if row["asked_sure"] else "–"]
        for one in row["answers"]
    ]
    if cells:
        head = [tell(template("prediction")), tell(template("students")), tell(template("sure"))]
        parts.append(table(head, cells, kind="item"))
    if row["more"]:
        more = said("and {n} more, each in other words.", n=f"{row['more']}")
        parts.append(f"<p>{tell(more)}</p>")
    reasons = "".join(
        f"<li>{person(one['student'], tell)} ({tell(one['said'])}): {text(one['why'])}</li>"
        for one in row["reasons"]
    )
    if reasons:
        count = len(row["reasons"])
        why = counted("Why: 1 reason", "Why: {n} reasons", n=count)
        parts.append(
            f"<details><summary>{tell(why)}</summary>"
            f'<ul class="carts-class-says">{reasons}</ul></details>'
        )
    return f'<div class="carts-class-item">{"".join(parts)}</div>'


def _how_many(row: Row) -> str:
    count = counted("1 prediction", "{n} predictions", n=row["n"])
    sentence = said("{sentence}.", sentence=count)
    if open_ones := row["n"] - row["locked"]:
        sentence = said(
            "{predictions}, {n} of them not locked.", predictions=count, n=f"{open_ones}"
        )
    return joined(sentence, again_sentence(row))


def again_sentence(row: Row) -> str:
    """How many had seen the run; empty: nobody."""
    if not row["again"]:
        return ""
    return counted(
        "1 was made again by a student who had seen the run; it is not counted.",
        "{n} were made again by students who had seen the run; they are not counted.",
        n=row["again"],
    )
