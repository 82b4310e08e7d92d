"""What tables are called where several files have one name."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import PurePosixPath


def distinct(paths: Sequence[str]) -> list[str]:
    """The files' names; with their folders where two are alike, and a number where those are too.

    By its name a row without a student's name is told from that of another table.
    """
    short = [PurePosixPath(path).name for path in paths]
    often, seen, names = Counter(short), Counter[str](), []
    for path, name in zip(paths, short, strict=True):
        whole = path if often[name] > 1 else name
        seen[whole] += 1
        names.append(whole if seen[whole] == 1 else f"{whole} ({seen[whole]})")
    return names
