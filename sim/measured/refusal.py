"""Why a file or a fit is refused: the line, the reason, and how it should look."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from sim.measured.track import FEWEST, Content
from sim.scene.said import Said, counted, said


@dataclass(frozen=True, slots=True, order=True)
class Fault:
    """One mistake in a file, at `line` (counted from 1). `cell`: what stands where it is."""

    line: int
    reason: str
    hint: str = ""
    cell: str = ""

    def __str__(self) -> str:
        return f"line {self.line}: {self.reason}" + (f"\n  hint: {self.hint}" if self.hint else "")

    def column(self, text: str) -> int:
        """Where its cell begins in its line of `text`, in characters from 1; 1 without a cell."""
        lines = re.split(r"\r\n|\r|\n", text.removeprefix("\ufeff"))
        line = lines[self.line - 1] if self.cell and self.line <= len(lines) else ""
        found = re.search(rf"(?<![^\s;,|\"]){re.escape(self.cell)}(?![^\s;,|\"])", line)
        return found.start() + 1 if found else 1


class ReadingError(ValueError):
    """A file that cannot be used. Carries what was found wrong, in the order of lines.

    `source`: which of several texts it is, from 0.
    """

    def __init__(self, faults: Iterable[Fault], source: int = 0) -> None:
        self.faults, self.source = tuple(sorted(faults)), source
        super().__init__("\n".join(str(fault) for fault in self.faults))


class FitError(ValueError):
    """Good readings that this model cannot be fitted to; `hint` says what would help.

    `code`: the reason for programs, `no-fit` where there is no better one.
    """

    def __init__(self, reason: str, hint: str = "", code: str = "no-fit") -> None:
        super().__init__(reason)
        self.reason, self.hint, self.code = reason, hint, code


def refuse(line: int, reason: str, hint: str = "") -> ReadingError:
    """One fault as an error, to be raised."""
    return ReadingError([Fault(line, reason, hint)])


def in_line(line: object) -> Said:
    """A line of the file, in a sentence: a page calls it what it is there, row 2 of a table."""
    return said("line {line}", line=str(line))


def of_readings(count: int) -> Said:
    """1 reading, 2 readings."""
    return counted("1 reading", "{n} readings", n=count)


def too_few(count: int, cart: str) -> Said:
    """Of the readings of one cart."""
    return said(
        "{readings} of “{cart}”: at least {least} are needed",
        readings=of_readings(count),
        cart=shown(cart),
        least=str(FEWEST),
    )


def of_things(count: int, kind: Content) -> Said:
    """1 cart, 2 phones: what so many tracks of a kind are of."""
    if kind == "force":
        return counted("1 force sensor", "{n} force sensors", n=count)
    if kind == "acceleration":
        return counted("1 phone", "{n} phones", n=count)
    return counted("1 cart", "{n} carts", n=count)


def no_number(cell: str) -> Said:
    """Of a cell in the place of a number."""
    return said("“{cell}” is not a number", cell=shown(cell))


def too_large(number: str) -> tuple[Said, Said]:
    """Reason and hint."""
    return said("{number} is too large", number=number), said("is this number a reading?")


def only(count: int, whose: str, *, after: bool) -> Said:
    """Of too few readings before or after a contact."""
    if after:
        return counted(
            "only 1 reading of {cart} lies after the contact",
            "only {n} readings of {cart} lie after the contact",
            n=count,
            cart=whose,
        )
    return counted(
        "only 1 reading of {cart} lies before the contact",
        "only {n} readings of {cart} lie before the contact",
        n=count,
        cart=whose,
    )


def shown(text: str) -> str:
    """What stood in the file, as a message shows it: one line of printable characters, short."""
    text = "".join(c if c.isprintable() else "·" for c in text.strip())
    return text if len(text) <= 30 else f"{text[:27]}…"
