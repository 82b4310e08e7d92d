"""A table that lies on its side: a line for each quantity, a column for each frame.

t (s);0.00;0.03;0.07;...
A (m);0.300;0.318;0.336;...
B (m);1.000;1.001;0.999;...
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import zip_longest

FEWEST, MOST = 3, 8
"""Lines of such a table: the time and two carts at least, and what else a device takes."""

FRAMES = 8

_NUMBER = re.compile(r"[-+\u2212]?[\d.,]+(?:[eE][-+]?\d+)?")


def stood_up(rows: Sequence[tuple[str, ...]]) -> list[tuple[str, ...]] | None:
    """The same table with a row for each frame; None where it does not lie on its side. Lines of
    one or two cells above it are remarks, and go."""
    wide = [row for row in rows if len(row) > 2]
    if not FEWEST <= len(wide) <= MOST or len(rows) - len(wide) > MOST:
        return None
    for name, *cells in wide:
        numbers = sum(_NUMBER.fullmatch(cell) is not None for cell in cells)
        if not name or _NUMBER.fullmatch(name) or numbers < max(FRAMES, 0.5 * len(cells)):
            return None
    return list(zip_longest(*wide, fillvalue=""))
