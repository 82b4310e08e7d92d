"""What students think and predicted: beliefs behind wrong answers, and what was said before a run.

Beliefs and predictions are counted in the database. Reasons and drawn curves are one student's
each: they stay in the table.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.report.beliefs import OFTEN, belief_row
from sim.classroom.report.most_said import MOST
from sim.country.counted import FORM
from sim.country.rows import BETWEEN
from sim.lesson.answer_file import PREDICTIONS


def beliefs_in(mine: Any) -> Any:
    """Students who chose answers of one belief in so many questions that it is named."""
    wrong = mine.filter(mine.keyed, mine.position.notnull(), mine.beliefs != "")
    tags = wrong.select(
        *FORM, "sheet", "item", tag=wrong.beliefs.split(BETWEEN).unnest(), sure=wrong.sure
    ).distinct()
    of_student = tags.group_by(*FORM, "sheet", "tag").agg(
        n=tags.count(), certain=(tags.sure == "sure").sum()
    )
    often = of_student.filter(of_student.n >= OFTEN)
    return often.group_by(*FORM, "tag").agg(
        students=often.count(), sure=(often.certain >= OFTEN).sum()
    )


def predictions_in(mine: Any) -> Any:
    """Predictions of files that are not foreign, by their words."""
    found = mine.filter(~mine.sheet_foreign, mine.answered, mine.type.isin(PREDICTIONS))
    before = found.again.isnull()  # the others had seen the run
    return found.group_by(*FORM, "item", "type", "chosen").agg(
        n=before.sum(), certain=(before & (found.sure == "sure")).sum(),
        told=(before & (found.sure != "")).sum(),
        shut=(before & found.locked).sum(), again=found.again.notnull().sum(),
        ask=found.asked.max(), begun=found["first"].min(),
    )  # fmt: skip


def belief_rows_of(
    cells: Sequence[Mapping[str, Any]], key: KeyedForm | None
) -> list[dict[str, Any]]:
    """The beliefs of a form, the most frequent first."""
    items = key.items.values() if key else ()
    says = {tag: text for item in items for tag, text in item.beliefs.items()}
    asked = any(item.question.common.sure for item in items)
    order = sorted(cells, key=lambda cell: (-cell["students"], cell["tag"]))
    return [
        belief_row(c["tag"], says.get(c["tag"], c["tag"]), c["students"],
                   c["sure"] if asked else None)
        for c in order
    ]  # fmt: skip


def prediction_rows_of(cells: Sequence[Mapping[str, Any]]) -> list[dict[str, Any]]:
    """The predictions of a form, scene by scene in the order in which they were met."""
    scenes: dict[str, list[Mapping[str, Any]]] = {}
    for cell in cells:
        scenes.setdefault(cell["item"], []).append(cell)
    met = {
        name: min((c["begun"].isoformat() if c["begun"] else "") for c in found)
        for name, found in scenes.items()
    }
    return [_row(name, scenes[name]) for name in sorted(scenes, key=lambda n: (met[n], n))]


def _row(name: str, cells: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    kind = min(cell["type"] for cell in cells)
    counted = [cell for cell in cells if cell["n"]] if kind != "curve" else []
    order = sorted(counted, key=lambda cell: (-cell["n"], cell["chosen"]))
    return {
        "id": name, "type": kind, "ask": max((c["ask"] or "" for c in cells), default=""),
        "n": sum(c["n"] for c in cells), "again": sum(c["again"] for c in cells),
        "asked_sure": any(c["told"] for c in cells), "locked": sum(c["shut"] or 0 for c in cells),
        "answers": [{"said": c["chosen"], "count": c["n"], "sure": c["certain"]}
                    for c in order[:MOST]],
        "more": max(0, len(order) - MOST), "curves": [], "reasons": [],
    }  # fmt: skip
