"""Tables of marks made up for tests, and the report on them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from sim.classroom.statistics.spread import Exact
from sim.classroom.tables.read import read_table
from sim.classroom.tables.report import Judged, judge, table_report
from sim.classroom.tables.taken import Taken


def csv(head: Sequence[str], rows: Sequence[Sequence[object]], delimiter: str = ",") -> bytes:
    """A table as bytes; no cell holds the delimiter."""
    lines = [delimiter.join(map(str, row)) for row in [head, *rows]]
    return "\r\n".join(lines).encode()


def by_column(row: Taken) -> str:
    """The group that the table tells, else one for all."""
    return row.group or "class"


def judged(
    *contents: bytes,
    most: Exact | None = None,
    forms: Sequence[str] = (),
    group_of: Callable[[Taken], str] = by_column,
) -> Judged:
    """Tables read as one lesson called marks."""
    tables = [
        read_table(f"marks{k or ''}.csv", content, forms[k] if forms else "")
        for k, content in enumerate(contents)
    ]
    return judge("marks", tables, group_of, most=most)


def reported(*contents: bytes, **asked: Any) -> dict[str, Any]:
    """The report on them."""
    return table_report(judged(*contents, **asked))


def marks_with(n: int, total: int, squares: int, of: int) -> list[int]:
    """n whole marks from 0 to `of` with this sum and this sum of squares, or a little more.

    From marks as equal as can be, two at a time are moved apart by one mark each; this adds
    2(b − a + 1) to the squares; the smallest step there is comes first.
    """
    marks = sorted([total // n + (k < total % n) for k in range(n)])
    while sum(m * m for m in marks) < squares:
        steps = {
            2 * (marks[j] - marks[i] + 1): (i, j)
            for i in range(n)
            for j in range(n)
            if i != j and marks[i] > 0 and marks[j] < of and marks[j] >= marks[i]
        }
        i, j = steps[min(steps)]
        marks[i] -= 1
        marks[j] += 1
    return sorted(marks)


def paired_with(x: Sequence[int], y: Sequence[int], products: int) -> list[int]:
    """y in an order with this sum of products with x, or as near as single exchanges lead."""
    order, off = list(y), sum(a * b for a, b in zip(x, y, strict=True)) - products
    for _ in range(10_000):
        if off == 0:
            break
        changes = {
            (x[j] - x[i]) * (order[j] - order[i]): (i, j)
            for i in range(len(x))
            for j in range(i)
            if x[i] != x[j] and order[i] != order[j]
        }
        best = min(changes, key=lambda change: abs(off - change))
        if abs(off - best) >= abs(off):
            break
        i, j = changes[best]
        order[i], order[j] = order[j], order[i]
        off -= best
    return order
