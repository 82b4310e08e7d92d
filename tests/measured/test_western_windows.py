"""A table of readings as German Excel writes plain CSV: windows-1252."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.sheet.cells import decoded

TEXT = "t in s;x von Wägelchen A in m;x von Wägelchen B in m\n0,00;0,40;1,20\n0,05;0,42;1,20\n"


def test_umlauts_of_western_windows_are_read() -> None:
    assert decoded(TEXT.encode("cp1252")) == TEXT
    assert decoded(TEXT.encode()) == TEXT
    assert decoded(TEXT.encode("utf-16")) == TEXT


def test_a_picture_is_no_text() -> None:
    with pytest.raises(ReadingError, match="no text"):
        decoded(b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR")
