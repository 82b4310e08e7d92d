"""Tables that a program made, a module each: which one wrote it, and what its columns are."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sim.classroom.tables.exports import google, microsoft, moodle, moodle_grades, ours
from sim.classroom.tables.layout import Layout

EXPORTS: tuple[Callable[[Sequence[str]], Layout | None], ...] = (
    moodle.layout,
    moodle_grades.layout,
    google.layout,
    microsoft.layout,
    ours.layout,
)
"""Each says what it knows of a row of headings; None where another program wrote it."""
