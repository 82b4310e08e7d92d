"""Predictions of a class as HTML: what was expected how often, curves over each other, reasons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.show.drawing import curves
from sim.classroom.show.html_parts import table, text, who

Row = Mapping[str, Any]


def predictions_html(rows: Sequence[Row]) -> str:
    """All scenes that asked first; nothing where none did."""
    if not rows:
        return ""
    each = "".join(map(_prediction, rows))
    return f"<h4>Predicted before the run</h4>{each}"


def _prediction(row: Row) -> str:
    open_ones = row["n"] - row["locked"]
    left = f", {open_ones} of them not locked" if open_ones else ""
    title = f"<h5>{text(row['ask'] or row['id'])}</h5>"
    parts = [title, f'<p class="carts-class-quiet">{row["n"]} predictions{left}.</p>']
    if row["curves"]:
        parts.append(f"<figure>{curves(row['curves'])}</figure>")
    cells = [
        [text(one["said"]), str(one["count"]), str(one["sure"]) if one["sure"] else "–"]
        for one in row["answers"]
    ]
    if cells:
        parts.append(table(["prediction", "students", "sure"], cells, kind="item"))
    if row["more"]:
        parts.append(f"<p>and {row['more']} more, each in other words.</p>")
    reasons = "".join(
        f"<li>{who(one['student'])} ({text(one['said'])}): {text(one['why'])}</li>"
        for one in row["reasons"]
    )
    if reasons:
        count = len(row["reasons"])
        parts.append(
            f"<details><summary>Why: {count} {'reason' if count == 1 else 'reasons'}</summary>"
            f'<ul class="carts-class-says">{reasons}</ul></details>'
        )
    return f'<div class="carts-class-item">{"".join(parts)}</div>'
