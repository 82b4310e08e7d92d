"""Signs in numbers that could be read in two ways: refused with the line, never guessed."""

from __future__ import annotations

import re
from collections.abc import Sequence

from sim.measured.refusal import Fault, in_line, refuse, shown
from sim.measured.sheet.cells import CellRow, numbers, plain
from sim.scene.said import said


def check_decimals(rows: Sequence[CellRow]) -> None:
    """Refuses a text in which some numbers have a decimal point and others a decimal comma."""
    seen: dict[str, tuple[int, str]] = {}
    for line, cell in numbers(rows):
        sign = "," if "," in cell else "." if "." in cell else ""
        other = seen.get("." if sign == "," else ",") if sign else None
        if other is not None:
            reason = said(
                "“{cell}” has another decimal sign than “{other}”",
                cell=shown(cell),
                other=shown(other[1]),
            )
            if other[0] != line:
                reason = said("{reason} in {line}", reason=reason, line=in_line(other[0]))
            raise refuse(line, reason, said("use the point or the comma in the whole file"))
        if sign:
            seen.setdefault(sign, (line, cell))


_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2}[.,]\d{3}")
_WHOLE = re.compile(r"[+-]?[1-9]\d{2}")
_FINE = re.compile(r"[+-]?[1-9]\d?,\d{3}")


def check_thousands(rows: Sequence[CellRow], units: Sequence[str]) -> None:
    """Refuses a column in which 1,148 is most probably more than a thousand, and not 1.148.

    Whole numbers of three digits beside it say so, where every sign has three digits behind it
    (900, 1,148); and so do thousandths of a millimetre or of a millisecond, which nobody reads.
    """
    for k in range(max((len(row.cells) for row in rows), default=0)):
        column = [(row.line, plain(row.cells[k])) for row in rows if k < len(row.cells)]
        signed = [(line, cell) for line, cell in column if "," in cell or "." in cell]
        if not signed or not all(_THOUSANDS.fullmatch(cell) for _, cell in signed):
            continue
        whole = any(_WHOLE.fullmatch(cell) for _, cell in column)
        fine = k < len(units) and units[k] in ("mm", "ms")
        if whole or (fine and all(_FINE.fullmatch(cell) for _, cell in signed)):
            line, cell = signed[0]
            reason = said(
                "“{cell}” could be a thousand times what it says: is that a decimal sign?",
                cell=shown(cell),
            )
            hint = said(
                "write thousands without a sign ({whole}), or all decimals",
                whole=re.sub("[.,]", "", cell),
            )
            raise refuse(line, reason, hint)


def two_readings(row: CellRow, columns: int) -> Fault | None:
    """The fault of a line in which the comma stands between cells and inside of numbers."""
    if columns and len(row.cells) >= 2 * columns - 1 and len(row.cells) > columns:
        reason = said(
            "{count} numbers under {names} names: is the comma a decimal sign?",
            count=str(len(row.cells)),
            names=str(columns),
        )
        hint = said("export with tabs or semicolons between the columns")
        return Fault(row.line, reason, hint)
    return None
