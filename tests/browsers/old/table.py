"""What was seen in old browsers, as the table of the docs."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

SEEN = Path(__file__).parent / "seen.json"
COLUMNS = (
    "Chrome or Edge", "readable", "its run plays", "Python live", "answers kept",
    "says what is wrong",
)  # fmt: skip


def table(seen: Mapping[str, Mapping[str, bool]]) -> str:
    """Markdown, the oldest first. What is live has nothing to say."""
    rows = [f"| {' | '.join(COLUMNS)} |", "|---" * len(COLUMNS) + "|"]
    for version, its in seen.items():
        said = "–" if its["live"] else word(its["told"])
        marks = (word(its[name]) for name in ("readable", "plays", "live", "kept"))
        rows.append(f"| {version} | {' | '.join(marks)} | {said} |")
    return "\n".join(rows)


def word(works: bool) -> str:
    """Yes or no, so that nobody has to guess at a sign."""
    return "yes" if works else "**no**"
