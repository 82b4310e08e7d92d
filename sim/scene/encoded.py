"""Text that a spreadsheet saved in the encoding of its Windows, which names itself nowhere.

Excel's plain CSV is windows-1252 in the west and GBK in China. Read as the other it becomes signs
that mean nothing: headings are not known any more, and with them go units and names.
"""

from __future__ import annotations

_USUAL = range(0xB0, 0xD8)
"""First bytes of the 3755 most usual Chinese characters. In windows-1252 they are signs and
capitals with accents, of which two seldom stand side by side."""


def of_a_spreadsheet(content: bytes) -> str:
    """The bytes as text; raises `UnicodeDecodeError` where they are of neither encoding."""
    try:
        text = content.decode("gb18030")
    except UnicodeDecodeError:
        return content.decode("cp1252")
    return text if _is_chinese(text) else content.decode("cp1252")


def _is_chinese(text: str) -> bool:
    """Whether most characters beyond ASCII are usual Chinese ones, or signs that go with them."""
    beyond = [sign.encode("gb18030") for sign in text if not sign.isascii()]
    usual = sum(
        len(pair) == 2 and (pair[0] in _USUAL or pair[0] in (0xA1, 0xA3)) and pair[1] > 0xA0
        for pair in beyond
    )
    return 2 * usual > len(beyond)
