"""Reports of made classes, and two groups that are compared."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sim.classroom.files.reading import Reading, Source
from sim.classroom.report.report import Asked, class_report
from tests.classroom.given.makers import bank, keys, random_class, sources

BANK = bank(10)
WHO = ("files", "flags", "students", "before", "after", "without_before", "without_after",
       "of_another_text")  # fmt: skip
"""What tells who is in a report, or what else was in the files."""


def made(
    *groups: tuple[str, list[dict[str, Any]]], source: Any = BANK, **asked: Any
) -> dict[str, Any]:
    reading = Reading.of([Source("key.json", keys(source).encode())])
    files = []
    for name, answer_files in groups:
        files += [(read, name) for read in Reading.of(sources(answer_files)).files]
    names = tuple(name for name, _ in groups)
    return class_report(files, reading.keys, [], Asked(groups=names, **asked))


def two(**asked: Any) -> dict[str, Any]:
    one = random_class(BANK, 25, seed=1, gain=0.35, prefix="FOX")
    other = random_class(BANK, 22, seed=2, gain=0.1, prefix="OWL")
    return made(("new", one), ("usual", other), **asked)["lessons"][0]["comparison"]


def without(value: Any, names: Sequence[str]) -> Any:
    """A report without these parts of it, wherever they stand."""
    if isinstance(value, dict):
        return {k: without(v, names) for k, v in value.items() if k not in names}
    return [without(one, names) for one in value] if isinstance(value, list) else value
