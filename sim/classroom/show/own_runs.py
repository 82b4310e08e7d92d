"""Runs of their own as HTML: how often a challenge was tried, what was found, what was set."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from sim.classroom.report.numerals import runs, students
from sim.classroom.show.html_parts import Tell, table, text
from sim.lesson.answer_file import CHALLENGE, FOUND_FORCE
from sim.scene.said import counted, said, template

Row = Mapping[str, Any]


def own_runs_html(rows: Sequence[Row], tell: Tell) -> str:
    """All challenges, forces and readings; nothing where nobody changed a run."""
    if not rows:
        return ""
    title = tell(template("Runs of their own"))
    return f"<h4>{title}</h4>{''.join(_row(row, tell) for row in rows)}"


def _row(row: Row, tell: Tell) -> str:
    cells = [[tell(one["said"]), str(one["count"])] for one in row["said"]]
    more = f"<p>{tell(and_more(row['more']))}</p>" if row["more"] else ""
    head = [tell(HEADS.get(row["kind"], SET)), tell(template("students"))]
    listed = table(head, cells, kind="item") if cells else ""
    title = f"<h5>{text(row['ask'] or row['id'])}</h5>"
    says = tell(own_run_sentence(row))
    return f'<div class="carts-class-item">{title}<p>{says}</p>{listed}{more}</div>'


def and_more(count: int) -> str:
    """How many are not listed."""
    return said("and {n} more.", n=f"{count}")


def own_run_sentence(row: Row) -> str:
    """What the class did, in one sentence."""
    return SENTENCES.get(row["kind"], _read)(row)


def _challenge(row: Row) -> str:
    values = {"students": students(row["n"]), "runs": runs(row["runs"])}
    if row["found"]:
        return said("{students} tried {runs}; {found} found one.", found=f"{row['found']}",
                    **values)  # fmt: skip
    return said("{students} tried {runs}; nobody found one.", **values)


def _force(row: Row) -> str:
    return counted("{students} found it, in 1 try.", "{students} found it, in {n} tries.",
                   n=row["runs"], students=students(row["n"]))  # fmt: skip


def _read(row: Row) -> str:
    return said("{students} read it off a run with settings of their own.",
                students=students(row["n"]))  # fmt: skip


SENTENCES: dict[str, Callable[[Row], str]] = {CHALLENGE: _challenge, FOUND_FORCE: _force}
HEADS = {CHALLENGE: template("found with"), FOUND_FORCE: template("found")}
SET = template("set")
