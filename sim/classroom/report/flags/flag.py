"""A question to the teacher about some files."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Flag:
    """A question to the teacher about some files."""

    code: str
    sentence: str
    files: tuple[str, ...]
