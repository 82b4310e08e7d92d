"""An `evidence` block: a table of the paper, recomputed from the printed numbers beside the page.

```evidence
show: gains
```

What the paper prints and what is ours are marked apart.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from sim.classroom.paper import (
    Later,
    Law,
    largest_deviation,
    later,
    laws,
    same_sums,
    sizes,
    whole_total,
)
from sim.classroom.report.numerals import signed
from sim.classroom.show.html_parts import table
from sim.classroom.statistics.spread import Spread
from sim.pages.blocks.scene_block import Lesson, load_block
from sim.pages.findings import AuthorError, Finding
from sim.pages.text.fence_scan import Block
from sim.scene.notation import number

FILES = ("table-1.csv", "table-2.csv", "table-2-printed.csv", "table-3.csv")
OURS = '<span class="carts-ours">ours</span>'
ROUNDED = 0.0005  # what a printed mean may have lost
NAMES = {"first": "first law", "third": "third law"}


def evidence_block(block: Block, lesson: Lesson, *, first_line: int) -> str:
    """The table as HTML; raises `AuthorError`."""
    source = load_block(block, lesson.file, first_line=first_line)
    wanted = source.plain.get("show")
    if set(source.plain) != {"show"} or not isinstance(wanted, str) or wanted not in SHOWN:
        hint = f"show: one of {', '.join(SHOWN)}"
        message = "an evidence block shows one table of the paper"
        raise AuthorError([Finding(lesson.file, *source.place(()), "required", message, hint)])
    folder = next((f for f in lesson.scene_folders if (f / FILES[0]).is_file()), None)
    if folder is None:
        message = f"the printed numbers are missing: {', '.join(FILES)} beside this page"
        raise AuthorError(
            [Finding(lesson.file, *source.place(()), "missing-file", message, "see docs/evidence")]
        )
    made = SHOWN[wanted](_Numbers(folder))
    return f'<div class="carts carts-class-report carts-evidence">{made}</div>'


class _Numbers:
    """The printed tables."""

    def __init__(self, folder: Path) -> None:
        first, second, printed, third = (
            (folder / name).read_text(encoding="utf-8") for name in FILES
        )
        self.sizes, self.totals = sizes(first)
        self.laws: Mapping[str, Law] = laws(second, printed)
        self.later: Mapping[str, Later] = later(third)


def _sizes(numbers: _Numbers) -> str:
    rows = [[name, str(one), str(other)] for name, (one, other) in numbers.sizes.items()]
    one, other = numbers.totals
    fits = same_sums(list(numbers.sizes.values()), numbers.totals)
    rows.append(["as printed", f"<b>{one}</b>", f"<b>{other}</b>"])
    sums = " and ".join(str(sum(n[k] for n in numbers.sizes.values())) for k in (0, 1))
    said = f"The columns add up to {sums}: {'as printed' if fits else 'not as printed'}. {OURS}"
    return table(["teacher", "experimental", "control"], rows) + f"<p>{said}</p>"


def _gains(numbers: _Numbers) -> str:
    head = ["law", "group", "students", "before", "after", "gain"]
    head += ["printed Z, P", "recomputed Z, P"]
    rows = []
    for name, law in numbers.laws.items():
        for group, tested in (("experimental", law.experimental), ("control", law.control)):
            first = group == "experimental"
            rows.append([
                NAMES[name] if first else "", group, str(tested.before.n),
                *(_printed(s) for s in (tested.before, tested.after, tested.gain)),
                f"{number(law.printed_z)}, {law.printed_p:.3f}" if first else "",
                f"<b>{number(law.z.z)}, {law.z.inside:.3f}</b>" if first else "",
            ])  # fmt: skip
    return table(head, rows)


def _ours(numbers: _Numbers) -> str:
    head = ["number", "first law", "third law"]
    found = list(numbers.laws.values())
    rows = [
        ["p, two-sided: 1 − P", *(f"{law.z.p:.3f}" for law in found)],
        ["Z before teaching (baseline)", *(signed(law.baseline.z) for law in found)],
        ["Hake's gain, experimental", *(number(law.experimental.hake) for law in found)],
        ["Hake's gain, control", *(number(law.control.hake) for law in found)],
        ["Cohen's d of the gains", *(signed(law.d) for law in found)],
        ["difference adjusted for the pre-test ± standard error, marks", *map(_adjusted, found)],
        ["its 95 % interval", *map(_interval, found)],
        ["its p", *(f"{law.adjusted.test.p:.2f}" for law in found)],
    ]
    return (
        f"<p>{OURS}: experimental minus control, from the printed numbers.</p>{table(head, rows)}"
    )


def _later(numbers: _Numbers) -> str:
    head = ["law", "group", "students", "marks of 2", f"Z {OURS}"]
    head += [f"largest possible deviation {OURS}", f"sum of marks {OURS}"]
    rows = []
    for name, law in numbers.later.items():
        for group, spread in (("experimental", law.experimental), ("control", law.control)):
            first = group == "experimental"
            largest = largest_deviation(spread.mean + ROUNDED, spread.n, law.of)
            total = whole_total(spread.mean, spread.n)
            rows.append([
                f"{name} law" if first else "", group, str(spread.n), _printed(spread),
                f"<b>{number(law.z.z)}</b>" if first else "",
                f"{largest:.3f}" + ("" if spread.sd <= largest else ": <b>exceeded</b>"),
                "–" if total is None else str(total),
            ])  # fmt: skip
    return table(head, rows)


def _printed(spread: Spread) -> str:
    return f"{spread.mean:.3f} ± {spread.sd:.3f}"


def _adjusted(law: Law) -> str:
    test = law.adjusted.test
    return f"{signed(test.difference)} ± {number(test.se)}"


def _interval(law: Law) -> str:
    test = law.adjusted.test
    return f"{signed(test.low)} to {signed(test.high)}"


SHOWN = {"sizes": _sizes, "gains": _gains, "ours": _ours, "later": _later}
