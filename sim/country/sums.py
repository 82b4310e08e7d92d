"""The sums of lessons from counts: the same that answer files and tables of marks give."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from sim.classroom.files.keyed import KeyedForm
from sim.classroom.report.flags.sorted_out import ORDER
from sim.classroom.statistics.pair_sums import PairSums, pair_sums_of
from sim.classroom.statistics.spread import Exact
from sim.classroom.summary.sums import FormSums, GroupSums, LessonSums
from sim.country.asked import Asked, asked_in
from sim.country.cells import Cell, Counts
from sim.country.item_cells import item_sums_of

Keys = Mapping[tuple[str, str, str], KeyedForm]


def groups_of(counts: Counts) -> tuple[tuple[str, ...], dict[str, int]]:
    """Groups in their order, and how many classes each has."""
    order: dict[str, tuple[int, int]] = {}
    classes: Counter[str] = Counter()
    for cell in counts.groups:
        place = (cell["order"], cell["first"])
        order[cell["group"]] = min(order.get(cell["group"], place), place)
        classes[cell["group"]] += 1
    return tuple(sorted(order, key=lambda group: (order[group], group))), dict(classes)


def of_counted(counts: Counts) -> Counts:
    """The counts without answers of files that have no total: what may be handed on of items.

    Beside the sums of counted files, those of all files would tell the marks of a single student.
    """
    return replace(counts, cells=[cell for cell in counts.cells if not cell["sheet_foreign"]])


def lessons_of(counts: Counts, keys: Keys) -> list[LessonSums]:
    """All lessons of a table. `keys`: where the words of questions come from."""
    groups, classes = groups_of(counts)
    by_lesson: dict[tuple[str, str], dict[str, FormSums]] = {}
    whole, cells = _parted(counts.totals), _parted(counts.cells)
    for place in sorted(whole, key=lambda place: (*place[:2], ORDER.index(place[2]))):
        form = _form(place, whole[place], cells.get(place, []), counts, keys, groups)
        by_lesson.setdefault(place[:2], {})[place[2]] = form
    return [
        _lesson(site, lesson, forms, counts.pairs, groups, classes)
        for (site, lesson), forms in by_lesson.items()
    ]


def _parted(cells: Sequence[Cell]) -> dict[tuple[str, str, str], list[Cell]]:
    found: dict[tuple[str, str, str], list[Cell]] = {}
    for cell in cells:
        if cell["form"] in ORDER:
            found.setdefault((cell["site"], cell["lesson"], cell["form"]), []).append(cell)
    return found


def cells_of(cells: Sequence[Cell], place: tuple[str, str, str]) -> list[Cell]:
    """Those of one form: site, lesson, form."""
    return [c for c in cells if (c["site"], c["lesson"], c["form"]) == place]


def _form(
    place: tuple[str, str, str],
    totals: Sequence[Cell],
    cells: Sequence[Cell],
    counts: Counts,
    keys: Keys,
    groups: Sequence[str],
) -> FormSums:
    keyed = any(cell["keyed"] for cell in totals)
    if keyed:  # what was written without the key cannot be added to it
        totals, cells = ([c for c in rows if c["keyed"]] for rows in (totals, cells))
    waiting = {cell["item"] for cell in cells_of(counts.waiting, place)} if keyed else set()
    asked = asked_in(cells, keys.get(place) if keyed else None)
    good = any(not cell["foreign"] for cell in totals)
    counted = tuple(meta["id"] for meta in asked.items if meta["worth"] and good
                    and meta["id"] not in waiting)  # fmt: skip
    worth = {meta["id"]: meta["worth"] for meta in asked.items}
    return FormSums(
        form=place[2], has_key=keyed, of=sum(worth[name] for name in counted), counted=counted,
        unread=tuple(sorted(waiting)), items=asked.items,
        groups={
            group: _group(
                [c for c in totals if c["group"] == group],
                [c for c in cells if c["group"] == group], asked, counted, keyed=keyed,
            )
            for group in groups
        },
    )  # fmt: skip


def _group(
    totals: Sequence[Cell],
    cells: Sequence[Cell],
    asked: Asked,
    counted: Sequence[str],
    *,
    keyed: bool,
) -> GroupSums:
    listed = sum(cell["n"] for cell in totals)
    found: Counter[Exact] = Counter()
    for cell in totals:
        if not cell["foreign"]:
            found[cell["total"]] += cell["n"]
    by_item: dict[str, list[Cell]] = {meta["id"]: [] for meta in asked.items}
    for cell in cells:
        by_item[cell["item"]].append(cell)
    return GroupSums(
        listed=listed, totals=found,
        items={
            meta["id"]: item_sums_of(
                by_item[meta["id"]], meta, listed, counted=meta["id"] in counted, keyed=keyed
            )
            for meta in asked.items
        },
    )  # fmt: skip


def _lesson(
    site: str,
    lesson: str,
    forms: Mapping[str, FormSums],
    pairs: Sequence[Cell],
    groups: Sequence[str],
    classes: Mapping[str, int],
) -> LessonSums:
    both = [forms[name] for name in ("pre", "post") if name in forms]
    paired = len(both) == 2 and both[0].counted and both[0].of == both[1].of
    mine = [c for c in pairs if (c["site"], c["lesson"]) == (site, lesson)] if paired else []
    of = both[0].of if paired else None
    return LessonSums(
        site=site, lesson=lesson, forms=forms,
        pairs={group: _pairs(mine, group, of) for group in groups} if paired else {},
        pairs_of=of,
        same_items=bool(paired) and {*both[0].counted} == {*both[1].counted},
        classes={group: classes.get(group, 1) for group in groups},
    )  # fmt: skip


def _pairs(cells: Sequence[Cell], group: str, of: Any) -> PairSums:
    counts: Counter[tuple[Exact, Exact]] = Counter()
    for cell in cells:
        if cell["group"] == group:
            counts[cell["before"], cell["after"]] += cell["n"]
    return pair_sums_of(counts, of)
