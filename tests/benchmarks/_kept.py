"""What is kept of a whole run of `make bench`: `measured.json`, and all that is made from it.

The page *Measured* of the docs and the badges of the README hold no number that is not in that
file; a test makes them anew and compares.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from datetime import date
from html import escape
from pathlib import Path
from typing import Any

from tests.benchmarks._rows import Row, goal_text, missed

ROOT = Path(__file__).parents[2]
FILE = Path(__file__).parent / "measured.json"
PAGE = ROOT / "docs" / "accuracy" / "measured.md"
BADGES = ROOT / "docs" / "assets" / "badges"

_KILLED = "answers lost to a killed browser"
_WEIGHT = "lesson page without runtime, gzip"
_LETTER = 6.6  # px, about the width of a letter of 11 px
_GOOD, _POOR, _LABEL = "#1a7f37", "#8a5f00", "#444b55"

_HEAD = """\
---
title: Measured
hide: [toc]
search:
  exclude: true # numbers by the hundred
---

# Measured

Goals of this project, and what one run of `make bench` found, on {date}: {machine}{versions}.
**{reached} of {goals} goals were reached.** Nothing here was put in by hand: the command writes
this page, and a test compares the two.

Times depend on the computer and on what else it does. So most goals are ratios of two things that
ran in turn in the same minutes; a time in seconds says what this computer took, no more. Accuracy
and sizes do not depend on it.
"""


def document(
    rows: Iterable[Row], areas: dict[str, str], left_out: dict[str, str], about: dict[str, Any]
) -> dict[str, Any]:
    """What is written to `measured.json`. `areas`: what each is about; `left_out`: why each was not
    measured; `about`: `date` (a day), `machine`, `versions`, and maybe a `remark`."""
    return {"format": 1, **about, "areas": areas, "left_out": left_out, "rows": list(rows)}


def keep(made: dict[str, Any]) -> None:
    """Write the document, the page and the badges."""
    FILE.write_text(json.dumps(made, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    PAGE.write_text(page(made), encoding="utf-8")
    BADGES.mkdir(exist_ok=True)
    for name, text in badges(made).items():
        (BADGES / name).write_text(text, encoding="utf-8")


def page(made: dict[str, Any]) -> str:
    """The Markdown of *Measured*."""
    day = date.fromisoformat(made["date"])
    with_goal = [row for row in made["rows"] if row["goal"] is not None]
    failed = [row for row in with_goal if missed(row)]
    versions = "".join(f", {name} {version}" for name, version in made["versions"].items())
    parts = [
        _HEAD.format(
            date=f"{day.day} {day:%B %Y}",
            machine=made["machine"],
            versions=versions,
            reached=len(with_goal) - len(failed),
            goals=len(with_goal),
        )
    ]
    if made.get("remark"):
        parts.append(f"{made['remark']}\n")
    if failed:
        rows = [f"- {row['name']}: {_value(row)}, goal {goal_text(row)}" for row in failed]
        parts.append("\n".join(["## What was missed", "", *rows, ""]))
    if made["left_out"]:
        rows = [f"- *{name}*: {why}" for name, why in made["left_out"].items()]
        parts.append("\n".join(["## What could not be measured", "", *rows, ""]))
    for area, about in made["areas"].items():
        parts.append(_table(area, about, [row for row in made["rows"] if row["area"] == area]))
    return "\n".join(parts)


def badges(made: dict[str, Any]) -> dict[str, str]:
    """File name → SVG: three numbers that say something to somebody who arrives."""
    rows = made["rows"]
    goals = [row for row in rows if row["goal"] is not None]
    reached = sum(not missed(row) for row in goals)
    killed = [row for row in rows if row["name"].startswith(_KILLED)]
    lost = round(sum(row["value"] for row in killed))
    kills = sum(int(row["reference"].split()[0]) for row in killed)
    (weight,) = (row for row in rows if row["name"] == _WEIGHT)
    return {
        "answers.svg": _badge("answers lost when killed", f"{lost} of {kills}", lost == 0),
        "weight.svg": _badge(
            "a lesson, before Python", f"{weight['value']:.0f} kB", not missed(weight)
        ),
        "goals.svg": _badge(
            "goals reached", f"{reached} of {len(goals)}", reached > 0.9 * len(goals)
        ),
    }


def _table(area: str, about: str, rows: list[Row]) -> str:
    lines = [
        f"## {about}",
        "",
        f"`make bench AREA={area}`",
        "",
        "| what | measured | goal | against |",
        "|---|---|---|---|",
    ]
    for row in rows:
        goal = goal_text(row) and f"{goal_text(row)} {'**missed**' if missed(row) else '✓'}"
        lines.append(f"| {row['name']} | {_value(row)} | {goal} | {row['reference']} |")
    return "\n".join([*lines, ""])


def _value(row: Row) -> str:
    return f"{row['value']:.3g} {row['unit']}".rstrip()


def _badge(label: str, value: str, good: bool) -> str:
    left, right = (round(_LETTER * len(text) + 14) for text in (label, value))
    said, colour = escape(f"{label}: {value}"), _GOOD if good else _POOR
    style = 'fill="#fff" font-family="Verdana,DejaVu Sans,sans-serif" font-size="11"'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + right}" height="20" role="img" '
        f'aria-label="{said}"><title>{said}</title>'
        f'<path fill="{_LABEL}" d="M3 0H{left}V20H3a3 3 0 0 1-3-3V3a3 3 0 0 1 3-3z"/>'
        f'<path fill="{colour}" d="M{left} 0h{right - 3}a3 3 0 0 1 3 3v14a3 3 0 0 1-3 3H{left}z"/>'
        f'<g {style} text-anchor="middle"><text x="{left / 2}" y="14">{escape(label)}</text>'
        f'<text x="{left + right / 2}" y="14">{escape(value)}</text></g></svg>\n'
    )
