"""The same students before and after, and who is missing where."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from sim.classroom.report.marked import Marked, counted_items, worth
from sim.classroom.report.numerals import in_order
from sim.classroom.statistics.pair_sums import PairSums, pair_sums


@dataclass(frozen=True, slots=True)
class Pairs:
    """Totals of students who took both forms, in one order; and who took only one of them, or
    answered another text in one: these have no total."""

    group: str
    students: tuple[str, ...]
    before: tuple[float, ...]
    after: tuple[float, ...]
    of: float
    without_before: tuple[str, ...]
    without_after: tuple[str, ...]
    of_another_text: tuple[str, ...]
    same_items: bool

    @property
    def sums(self) -> PairSums:
        """What their gain is computed from."""
        return pair_sums(self.before, self.after, self.of)


def pair_up(
    earlier: Sequence[Marked],
    later: Sequence[Marked],
    group: str,
    only: Collection[str] | None = None,
) -> Pairs | None:
    """Pairs of one group by pseudonym; None where the two forms have no marks to compare.

    A file that answers another version of the lesson is not paired. `only`: items to count.
    """
    took = [{f.student: f for f in files if f.group == group} for files in (earlier, later)]
    earlier, later = ([f for f in files if not f.foreign] for files in (earlier, later))
    first, second = ({n: f for n, f in files.items() if not f.foreign} for files in took)
    # What counts must not depend on the group: all files of the form decide.
    items = _counted(earlier, only)
    others = _counted(later, only)
    same = set(items) == set(others)
    of, of_later = worth(earlier, items), worth(later, others)
    if not items or of != of_later:
        return None
    both = sorted(first.keys() & second.keys(), key=in_order)
    return Pairs(
        group=group,
        students=tuple(first[name].who for name in both),
        before=tuple(float(first[name].total(items)) for name in both),
        after=tuple(float(second[name].total(others)) for name in both),
        of=float(of),
        without_before=_named(took[1], took[1].keys() - took[0].keys()),
        without_after=_named(took[0], took[0].keys() - took[1].keys()),
        of_another_text=_named(took[1], (took[0].keys() & took[1].keys()).difference(both)),
        same_items=same,
    )


def _named(files: Mapping[str, Marked], students: Iterable[str]) -> tuple[str, ...]:
    return tuple(files[student].who for student in sorted(students, key=in_order))


def _counted(files: Sequence[Marked], only: Collection[str] | None) -> tuple[str, ...]:
    items = counted_items(files)
    return items if only is None else tuple(name for name in items if name in only)
