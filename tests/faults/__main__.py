"""`make fuzz AREA=faults`: every fault as a table; it fails if one is silent or is seen otherwise
than it must be. With words, only the rows whose names hold one of them.
"""

from __future__ import annotations

import sys
import time
from collections import Counter

from .rows import rows
from .tried import BROKEN, OTHER, RIGHT, SILENT, UNTRIED


def main(words: list[str]) -> None:
    """The table; how many are silent or otherwise than they must be is the verdict."""
    began = time.monotonic()
    counts: Counter[str] = Counter()
    for row in rows(words):
        counts[row.verdict] += 1
        print(row, flush=True)
    minutes = (time.monotonic() - began) / 60
    print(
        f"{counts.total() - counts[UNTRIED]} faults in {minutes:.0f} min: {counts[SILENT]} silent,"
        f" {counts[OTHER]} otherwise than they must be, {counts[BROKEN]} broken,"
        f" {counts[RIGHT]} right;"
        f" {counts[UNTRIED]} not tried here"
    )
    sys.exit(1 if counts[SILENT] + counts[OTHER] + counts[BROKEN] else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
