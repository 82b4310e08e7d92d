"""Text that a spreadsheet saved in the encoding of its Windows, which names itself nowhere.

Excel's plain CSV is windows-1252 in the west, GBK in China, Big5 in Taiwan and Hong Kong. Read as
another it becomes signs that mean nothing: headings are not known any more, and with them go units
and names. `sim/web/src/measured/decoded.js` finds the same in the page.
"""

from __future__ import annotations

import re
from contextlib import suppress

_BEYOND = re.compile(rb"([\x80-\xff])([0-9]..|.|)", re.DOTALL)
"""A sign beyond ASCII, of two bytes; rare characters of GBK have a digit and two more behind it."""
_GBK = frozenset({0xA1, 0xA3, *range(0xB0, 0xD8)})
"""First bytes of the 3755 most usual Chinese characters and of signs, whose second byte is high. In
windows-1252 they are signs and capitals with accents, of which two seldom stand side by side."""
_BIG5 = range(0xA1, 0xC7)
"""The same of the 5401 most usual ones in Big5. Their second byte is a letter of ASCII as often as
not, and µm and °C look like one of them: so some must have two high bytes."""


def of_a_spreadsheet(content: bytes) -> str:
    """The bytes as text; raises `UnicodeDecodeError` where they are of none of these encodings."""
    if chinese := _chinese(content):
        with suppress(UnicodeDecodeError):
            return content.decode(chinese)
    return content.decode("cp1252")


def _chinese(content: bytes) -> str:
    """The encoding in which most signs beyond ASCII would be usual ones; empty: there is none."""
    beyond = in_gbk = in_big5 = high = 0
    for found in _BEYOND.finditer(content):
        first, second = found[1][0], (found[2] or b"\0")[0]
        beyond += 1
        in_gbk += first in _GBK and second > 0xA0
        if first in _BIG5:
            in_big5 += second > 0xA0 or 0x40 <= second <= 0x7E
            high += second > 0xA0
    if in_big5 > in_gbk and 5 * in_big5 >= 4 * beyond and 4 * high >= beyond:
        return "cp950"
    return "gb18030" if 2 * in_gbk > beyond else ""
