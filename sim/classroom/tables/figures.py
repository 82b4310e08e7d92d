"""Figures and signs of other scripts as those of ASCII: a keyboard for Chinese writes １２．５ as
wide as its letters, one for Arabic, Hindi or Tamil may have figures of its own.
"""

from __future__ import annotations

import unicodedata

_SIGNS = str.maketrans("．，／％－\u066b", ".,/%-.")
"""As wide as a Chinese letter; the last one is the decimal sign of Arabic."""
COMMAS = ("，", "；", "\u060c")
"""Between columns, where somebody typed the table on such a keyboard; the last one is Arabic."""


def plain(text: str) -> str:
    """The text with figures 0 to 9 and the signs that stand among them."""
    if text.isascii():
        return text
    figures = (str(unicodedata.decimal(sign, sign)) for sign in text)
    return "".join(figures).translate(_SIGNS)
