"""Times that cannot be, and forms in the wrong order."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime, timedelta

from sim.classroom.report.flags.flag import Flag
from sim.classroom.report.marked import Marked
from sim.scene.said import said

FEWEST = 5
"""Answers, before their pace says anything."""

HASTE = timedelta(seconds=2)
"""Per answer. Nobody reads a question faster."""


_FIRST_YEAR = 2020


def times(file: Marked, now: str) -> list[Flag]:
    """Times that cannot be: a wrong clock, a file that was edited, or a try in haste."""
    f = file.file
    if not f.created:
        return []  # a hand-in code
    created, saved = moment_of(f.created), moment_of(f.saved)
    strange = created is None or saved is None or created.year < _FIRST_YEAR
    strange = strange or (created is not None and saved is not None and saved < created)
    here = moment_of(now)
    ahead = bool(here and saved and saved > here + timedelta(days=1))
    moments = [
        (first, last)
        for item in f.items
        if (first := moment_of(item.first or "")) and (last := moment_of(item.last or ""))
    ]
    strange = strange or any(last < first or (saved and last > saved) for first, last in moments)
    flags = []
    if strange or ahead:
        text = said(
            "{who}: the times in this file cannot be right. Was the clock of that laptop wrong, or "
            "was the file changed by hand?",
            who=file.place,
        )
        flags.append(Flag("impossible-times", text, (file.name,)))
    elif len(moments) >= FEWEST:
        took = max(last for _, last in moments) - min(first for first, _ in moments)
        if took < HASTE * (len(moments) - 1):
            text = said("{who}: {n} answers in {seconds} s. Was this only a try?", who=file.place,
                        n=f"{len(moments)}", seconds=f"{took.seconds}")  # fmt: skip
            flags.append(Flag("in-haste", text, (file.name,)))
    return flags


def moment_of(text: str) -> datetime | None:
    """The instant that an ISO 8601 text names, or None."""
    try:
        moment = datetime.fromisoformat(text)
    except ValueError:
        return None
    return moment if moment.tzinfo else moment.replace(tzinfo=UTC)


def order(files: Sequence[Marked]) -> list[Flag]:
    """A later form that was finished before an earlier one was begun."""
    by_student: dict[tuple[str, str, str], dict[str, Marked]] = {}
    for file in files:
        f = file.file
        by_student.setdefault((f.site, f.lesson, file.student), {})[f.form] = file
    flags = []
    for forms in by_student.values():
        if "pre" in forms and "post" in forms:
            pre, post = forms["pre"], forms["post"]
            begun, ended = moment_of(pre.file.created), moment_of(post.file.saved)
            if begun and ended and ended < begun:
                text = said(
                    "{who}: the form post was saved before the form pre was begun. Were the two "
                    "forms mixed up, or is a clock wrong?",
                    who=post.who,
                )
                flags.append(Flag("post-before-pre", text, (pre.name, post.name)))
    return flags
