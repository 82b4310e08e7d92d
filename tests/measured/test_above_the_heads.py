"""What stands above or beside the readings does not name the carts, nor their times."""

from __future__ import annotations

import pytest

from sim.measured.tracks import read_measured

ROWS = [f"{k / 20:.2f},{0.1 + 0.01 * k:.3f},{0.8 + 0.001 * k:.3f}" for k in range(20)]
HEADS = "t (s),x_A (m),x_B (m)"
REMARKS = "Gruppe 3\nWagen A: 0.500 kg\nWagen B: 1.000 kg\n"


def text(above: str, heads: str = HEADS) -> str:
    return above + "\n".join([heads, *ROWS]) + "\n"


@pytest.mark.parametrize("above", ["", REMARKS, "24.11.2026\n", "Wagen B: 1.000 kg\n"])
def test_heads_that_tell_two_carts_apart_name_them(above: str) -> None:
    assert read_measured([text(above)]).names == ("A", "B")


def test_a_remark_takes_no_names_from_carts_that_stand_before_a_colon() -> None:
    heads = "Time (s),B: Position (m),A: Position (m)"
    assert set(read_measured([text("Gruppe 3\n", heads)]).names) == {"A", "B"}


def test_excels_word_for_the_separator_is_no_name() -> None:
    found = read_measured(["sep=;\n" + text("").replace(",", ";")])
    assert found.names == ("A", "B")


@pytest.mark.parametrize("name", ["Uhrzeit", "Date and Time"])
def test_a_clock_of_whole_seconds_gives_way_to_a_time_that_rises(name: str) -> None:
    rows = [f"10:00:{k // 20:02d},{row}" for k, row in enumerate(ROWS)]
    found = read_measured(["\n".join([f"{name},Time (s) Run #1,x_A (m),x_B (m)", *rows]) + "\n"])
    assert found.tracks[0].t[:3] == pytest.approx((0.0, 0.05, 0.1))
