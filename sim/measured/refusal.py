"""Why a file or a fit is refused: the line, the reason, and how it should look."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, order=True)
class Fault:
    """One mistake in a file, at `line` (counted from 1)."""

    line: int
    reason: str
    hint: str = ""

    def __str__(self) -> str:
        return f"line {self.line}: {self.reason}" + (f"\n  hint: {self.hint}" if self.hint else "")


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


def of_readings(count: int) -> str:
    """1 reading, 2 readings."""
    return "1 reading" if count == 1 else f"{count} readings"


def only(count: int, whose: str, when: str) -> str:
    """Of too few readings before or after a contact."""
    return (
        f"only {of_readings(count)} of {whose} {'lies' if count == 1 else 'lie'} {when} the contact"
    )


def shown(text: str) -> str:
    """What stood in the file, as a message shows it: one line of printable characters, short."""
    text = "".join(c if c.isprintable() else "·" for c in text.strip())
    return text if len(text) <= 30 else f"{text[:27]}…"
