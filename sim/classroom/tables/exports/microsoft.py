"""The answers to a quiz of Microsoft Forms, saved as CSV: `Total points`, `Points - …`, `Email`."""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.classroom.tables.layout import Column, Layout, norm, place_of
from sim.classroom.tables.words import CLASS, GROUP, NUMBER, STUDENT

TOTAL = ("total points", "gesamtpunktzahl", "punkte gesamt", "jumlah mata", "总分", "总得分")
MAIL = ("email", "e-mail", "e-mel", "电子邮件")
NAME = ("name", "nama", "姓名", "名称")
_POINTS = re.compile(
    r"(?:points|punkte|mata|分数|得分|புள்ளிகள்)\s*[-–—]\s*(.+)", re.IGNORECASE | re.S
)


def layout(heads: Sequence[str]) -> Layout | None:
    """The columns of such an export, or None."""
    items = [
        Column(k, found[1].strip())
        for k, head in enumerate(heads)
        if (found := _POINTS.fullmatch(head)) and norm(found[1]) not in (*MAIL, *NAME)
    ]
    total = place_of(heads, TOTAL)
    if total is None or (
        not items
        and place_of(heads, ("completion time", "fertigstellungszeit", "masa siap", "完成时间"))
        is None
    ):
        return None  # fmt: skip
    asked = place_of(heads, STUDENT - NUMBER - {"name", "nama", "姓名"})
    # Not ID: it counts the answers to this form, so number 3 of two quizzes is no one student.
    ways = [asked, place_of(heads, MAIL), place_of(heads, NAME)]
    return Layout(
        kind="microsoft",
        student=tuple((k,) for k in ways if k is not None),
        group=place_of(heads, GROUP),
        klass=place_of(heads, CLASS),
        items=tuple(item for item in items if item.place != asked),
        totals=(Column(total, "total"),),
    )
