"""Thinking again: how often Check was pressed until an answer was right, what a run changed.

Files that were written before this was kept tell nothing of it, and are not counted.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from sim.classroom.files.keyed import KeyedItem
from sim.classroom.report.marked import Answer
from sim.lesson.mark import is_empty
from sim.scene.said import said


def tries_of(answers: Sequence[Answer]) -> dict[str, int] | None:
    """Students by the press on Check at which they were right; None where nobody pressed it."""
    presses = [a.item.right for a in answers if a.item and a.item.right is not None]
    if not presses:
        return None
    return {"first": presses.count(1), "later": sum(n > 1 for n in presses),
            "not_yet": presses.count(0)}  # fmt: skip


def changed_of(answers: Sequence[Answer], keyed: KeyedItem | None) -> dict[str, int] | None:
    """What became of answers that stood when the run was watched; None where none did.

    `n`: how many stood, `changed`: how many were changed since. Of these `to_right` became right
    and `to_wrong` were right before.
    """
    found: Counter[str] = Counter()
    for answer in answers:
        item = answer.item
        if item is None or is_empty(item.before.get("value")):
            continue
        found["n"] += 1
        if item.before["value"] == answer.value:
            continue
        found["changed"] += 1
        if keyed and keyed.worth and answer.mark:
            then = keyed.mark(item.before["value"], item.own).verdict == "right"
            now = answer.mark.verdict == "right"
            found["to_right"] += now and not then
            found["to_wrong"] += then and not now
    names = ("n", "changed", "to_right", "to_wrong")
    return {name: found[name] for name in names} if found["n"] else None


def thoughts(row: Mapping[str, Any]) -> list[str]:
    """Both in words, for the row of an item."""
    says: list[str] = []
    if tries := row["tries"]:
        says.append(said(
            "Right at the first press on Check: {first}, later: {later}, not yet: {not_yet}.",
            first=f"{tries['first']}", later=f"{tries['later']}", not_yet=f"{tries['not_yet']}",
        ))  # fmt: skip
    if changed := row["changed"]:
        values = {"n": f"{changed['n']}", "changed": f"{changed['changed']}"}
        says.append(
            said("{n} answered before they watched the run; {changed} of them changed it after: "
                 "{to_right} from wrong to right, {to_wrong} from right to wrong.",
                 to_right=f"{changed['to_right']}", to_wrong=f"{changed['to_wrong']}", **values)
            if row["worth"]
            else said("{n} answered before they watched the run; {changed} of them changed it "
                      "after.", **values)
        )  # fmt: skip
    return says
