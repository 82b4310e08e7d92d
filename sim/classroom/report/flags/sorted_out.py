"""What a teacher should look at before counting: worded as questions, never as a verdict.

A flag changes nothing in the numbers, except where two files claim the same place: `Sorted.counted`
leaves both out until the teacher has decided.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sim.classroom.report.flags.flag import Flag
from sim.classroom.report.flags.origin import foreign, nameless, told_right, unanswered
from sim.classroom.report.flags.times import order, times
from sim.classroom.report.marked import Marked
from sim.lesson.mark import is_empty
from sim.scene.said import joined, said, template

FEWEST_EQUAL = 5
"""Equal answers in two files below this number say nothing."""


ORDER = ("pre", "worksheet", "post", "delayed")


@dataclass(frozen=True, slots=True)
class Sorted:
    """The files that count, those that wait for the teacher, and the questions about them."""

    counted: tuple[Marked, ...]
    set_aside: tuple[Marked, ...]
    flags: tuple[Flag, ...]


def sort_out(files: Sequence[Marked], now: str = "") -> Sorted:
    """Flags, and which files count. `now`: ISO 8601 UTC, where the clock of the reader is known."""
    counted, aside, flags = _doubles(files)
    flags += _equal(counted)
    for file in counted:
        flags += times(file, now)
    flags += order(counted)
    flags += foreign(counted)
    flags += told_right(counted)
    flags += nameless(counted)
    flags += unanswered(counted)
    return Sorted(tuple(counted), tuple(aside), tuple(flags))


def _doubles(files: Sequence[Marked]) -> tuple[list[Marked], list[Marked], list[Flag]]:
    """One file for each student and form; of two saves of one student the later one."""
    places: dict[tuple[str, str, str, str], list[Marked]] = {}
    for file in files:
        places.setdefault(file.key, []).append(file)
    counted, aside, flags = [], [], []
    for same in places.values():
        if len(same) == 1:
            counted += same
            continue
        names = tuple(file.name for file in same)
        who = same[0].place
        typed = any(not file.file.created for file in same)  # a hand-in code has no times
        distinct = {digest(file, times=not typed) for file in same}
        if len(distinct) == 1:
            counted.append(same[0])
            aside += same[1:]
            text = said("{who}: is this the same file {times}? It is counted once.", who=who,
                        times=_times_word(len(same)))  # fmt: skip
            flags.append(Flag("same-file", text, names))
        elif not typed and len({file.file.created for file in same}) == 1:
            latest = max(same, key=lambda file: file.file.saved)
            counted.append(latest)
            aside += [file for file in same if file is not latest]
            text = said(
                "{who}: is this one student who saved {times}? The file saved last is counted.",
                who=who, times=_times_word(len(same)),
            )  # fmt: skip
            flags.append(Flag("saved-again", text, names))
        else:
            aside += same
            text = said(
                "{who}: {n} files have this code word. Are these two students, or one who began "
                "again? None of them is counted until you leave all but one out.",
                who=who, n=f"{len(same)}",
            )  # fmt: skip
            flags.append(Flag("doubled-id", text, names))
    return counted, aside, flags


def _times_word(count: int) -> str:
    return said("twice") if count == 2 else said("{n} times", n=f"{count}")


def digest(file: Marked, *, times: bool) -> str:
    """The answers of a file as something to compare; empty ones and the student are left out."""
    rows = sorted(
        [i.id, i.type, i.value, *([i.first, i.last] if times else [])]
        for i in file.file.latest().values()
        if not is_empty(i.value)
    )
    # The texts of 5,000 students would stay in memory: a digest of each is enough.
    return hashlib.sha256(json.dumps(rows, sort_keys=True).encode()).hexdigest()


def _equal(files: Iterable[Marked]) -> list[Flag]:
    """Different students with the same answers to everything."""
    found: dict[tuple[str, str, str, str], list[Marked]] = {}
    for file in files:
        answered = sum(not is_empty(item.value) for item in file.file.latest().values())
        if answered >= FEWEST_EQUAL:
            f = file.file
            found.setdefault((f.site, f.lesson, f.form, digest(file, times=False)), []).append(file)
    flags = []
    for same in found.values():
        if len(same) < 2:
            continue
        names = tuple(file.name for file in same)
        text: str = said("Same answers in {n} files. Partners and good students do this too.",
                         n=f"{len(same)}")  # fmt: skip
        right = all(a.marks == a.worth for file in same for a in file.answers.values())
        if right and any(a.worth for a in same[0].answers.values()):
            text = joined(text, template("Here all answers are right."))
        if len({digest(file, times=True) for file in same}) == 1:
            copied = template("The times are equal as well: is one a copy of the other?")
            text = joined(text, copied)
        text = joined(text, template("Ask before you judge."))
        flags.append(Flag("equal-files", text, names))
    return flags
