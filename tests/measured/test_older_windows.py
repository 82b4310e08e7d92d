"""A table of readings as Excel writes plain CSV: windows-1252 in the west, GBK in China, Big5
in Taiwan."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.sheet.cells import decoded
from sim.measured.tracks import read_measured
from tests.web.scene.given.widget_site import in_node

TEXT = "t in s;x von Wägelchen A in m;x von Wägelchen B in m\n0,00;0,40;1,20\n0,05;0,42;1,20\n"


def test_umlauts_of_western_windows_are_read() -> None:
    assert decoded(TEXT.encode("cp1252")) == TEXT
    assert decoded(TEXT.encode()) == TEXT
    assert decoded(TEXT.encode("utf-16")) == TEXT


def test_chinese_windows_are_read_with_their_units() -> None:
    text = "时间(毫秒),小车A位置(厘米),小车B位置(厘米)\n" + "".join(
        f"{50 * k},{40 + k},{120}\n" for k in range(12)
    )
    assert decoded(text.encode("gbk")) == text
    found = read_measured([decoded(text.encode("gbk"))])
    assert found.tracks[0].t[1] == pytest.approx(0.05)
    assert found.tracks[0].value[0] == pytest.approx(0.40)


def test_two_letters_with_accents_side_by_side_are_not_chinese() -> None:
    for text in ("Größe A;Größe B\n", "créée;º°\n", "ÄÖÜ;Länge\n", "Größe in m²; ±5 µm\n",
                 "Ähre in °C; µm; Åse\n", "t in µs, x in µm\n"):  # fmt: skip
        assert decoded(text.encode("cp1252")) == text


@pytest.mark.parametrize(
    ("encoding", "text"),
    [
        ("gbk", "时间(毫秒),小车A位置(厘米)\n0,40\n"),
        ("gb18030", "姓名,㐀,時間\n时间,位置,速度\n"),
        ("big5", "時間(毫秒),小車A位置(公分),小車B位置(公分)\n0,40,120\n"),
        ("big5", "姓名,前測,後測\n王小明,12,20\n"),
        ("gbk", "姓名,位置,速度,备注\n左边的小车,0,40,开始\n"),
        ("cp1252", "Größe in m²; créée; ÄÖÜ; ±5 µm\n"),
        ("cp1252", "Ähre in °C; µm; Åse\n"),
        ("utf-8-sig", TEXT),
        ("utf-16", TEXT),
    ],
)
def test_the_page_finds_the_same_text(encoding: str, text: str) -> None:
    content = text.encode(encoding)
    page = in_node(
        """const { decoded } = await import(source + "/measured/decoded.js");
        give(decoded(new Uint8Array(data).buffer));""",
        list(content),
    )
    assert page == decoded(content) == text


def test_a_picture_is_no_text() -> None:
    with pytest.raises(ReadingError, match="no text"):
        decoded(b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR")
