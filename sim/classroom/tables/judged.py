"""Which rows of tables count: one for each student and test, each student in one group."""

from __future__ import annotations

from collections.abc import Sequence

from sim.classroom.report.flags.flag import Flag
from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.sentences import rows_doubled, rows_equal, rows_nameless
from sim.classroom.tables.taken import Taken
from sim.scene.said import said, template

Refused = tuple[str, str]
NAMED = 12
"""Students without a name who are listed in one question."""


def judged(
    taken: Sequence[Taken], most: Exact | None
) -> tuple[list[Taken], list[str], list[Flag], list[Refused]]:
    """Rows that count, places set aside, questions, and rows refused for their group, or for a
    total above the most marks that somebody told."""
    above = [row for row in taken if most and row.of is None and (row.total or 0) > most]
    refused: list[Refused] = [
        (row.place, said("“{cell}” is more than the most marks", cell=f"{float(row.marks):g}"))
        for row in above
    ]
    wrong = {row.place for row in above}
    groups: dict[str, Taken] = {}
    good: list[Taken] = []
    for row in taken:
        if row.place in wrong:
            continue  # also its other tests
        if not row.group:
            refused.append((row.place, template("no group is given")))
            continue
        first = groups.setdefault(row.person, row)
        if (first.group, first.klass) != (row.group, row.klass):
            refused.append((row.place, said("this student is in another group or class ({row})",
                                            row=first.place)))  # fmt: skip
        else:
            good.append(row)
    counted, aside, flags = _once(good)
    nameless = list(dict.fromkeys(row.place for row in counted if not row.student))
    if nameless:
        flags.append(Flag("no-code", rows_nameless(len(nameless)), tuple(nameless[:NAMED])))
    return counted, aside, flags, list(dict.fromkeys(refused))


def _once(taken: Sequence[Taken]) -> tuple[list[Taken], list[str], list[Flag]]:
    places: dict[tuple[str, str], list[Taken]] = {}
    for row in taken:
        places.setdefault((row.person, row.form), []).append(row)
    counted: list[Taken] = []
    aside: list[str] = []
    flags: list[Flag] = []
    for same in places.values():
        if len(same) == 1:
            counted += same
            continue
        lines = tuple(row.place for row in same)
        if all(row.content == same[0].content for row in same):
            counted.append(same[0])
            aside += lines[1:]
            flags.append(Flag("same-file", rows_equal(same[0].who, len(same)), lines))
        else:
            aside += lines
            flags.append(Flag("doubled-id", rows_doubled(same[0].who, len(same)), lines))
    return counted, aside, flags
