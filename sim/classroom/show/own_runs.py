"""Runs of their own as HTML: how often a challenge was tried, what was found, what was set."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from sim.classroom.report.sentences import many
from sim.classroom.show.html_parts import table, text
from sim.lesson.answer_file import CHALLENGE, FOUND_FORCE

Row = Mapping[str, Any]


def own_runs_html(rows: Sequence[Row]) -> str:
    """All challenges, forces and readings; nothing where nobody changed a run."""
    if not rows:
        return ""
    return f"<h4>Runs of their own</h4>{''.join(map(_row, rows))}"


def _row(row: Row) -> str:
    cells = [[text(one["said"]), str(one["count"])] for one in row["said"]]
    more = f"<p>and {row['more']} more.</p>" if row["more"] else ""
    listed = table([HEADS.get(row["kind"], "set"), "students"], cells, kind="item") if cells else ""
    title = f"<h5>{text(row['ask'] or row['id'])}</h5>"
    return (
        f'<div class="carts-class-item">{title}<p>{own_run_sentence(row)}</p>{listed}{more}</div>'
    )


def own_run_sentence(row: Row) -> str:
    """What the class did, in one sentence."""
    return SENTENCES.get(row["kind"], _read)(row)


def _challenge(row: Row) -> str:
    tried = f"{many(row['n'], 'student')} tried {many(row['runs'], 'run')}"
    found = f"{row['found']} found one" if row["found"] else "nobody found one"
    return f"{tried}; {found}."


def _force(row: Row) -> str:
    return f"{many(row['n'], 'student')} found it, in {many(row['runs'], 'try', 'tries')}."


def _read(row: Row) -> str:
    return f"{many(row['n'], 'student')} read it off a run with settings of their own."


SENTENCES: dict[str, Callable[[Row], str]] = {CHALLENGE: _challenge, FOUND_FORCE: _force}
HEADS = {CHALLENGE: "found with", FOUND_FORCE: "found"}
