"""Lines as a microcontroller prints them: a name before each number, the monitor's own clock."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from tests.measured.uniform_logs import TIMES, A, B, places, table

PRINTED = {
    "of the plotter": "t:{:.2f},x_A:{:.2f},x_B:{:.2f}",
    "with spaces": "t: {:.2f} x_A: {:.2f} x_B: {:.2f}",
    "with tabs": "t:{:.2f}\tx_A:{:.2f}\tx_B:{:.2f}",
    "with units in the names": "Time (s): {:.2f}, Cart A (m): {:.2f}, Cart B (m): {:.2f}",
    "with units behind": "t = {:.2f} s; x_A = {:.2f} m; x_B = {:.2f} m",
    "with the monitor's clock": "10:33:{:06.3f} -> x_A:{:.2f},x_B:{:.2f}",
    "numbers alone behind the clock": "10:33:{:06.3f} -> {:.2f},{:.2f}",
    "with spaces behind the clock": "10:33:{:06.3f} -> {:.2f} {:.2f}",
}


def printed(line: str) -> str:
    return "".join(line.format(*row) + "\n" for row in zip(TIMES, A, B, strict=True))


@pytest.mark.parametrize("line", PRINTED.values(), ids=PRINTED)
def test_lines_that_name_their_numbers_are_rows_of_a_table(line: str) -> None:
    assert places(printed(line)) == {"A": pytest.approx(0.2), "B": pytest.approx(0.9)}


def test_units_behind_the_numbers_are_those_of_the_column() -> None:
    text = "".join(f"t: {1e3 * t:.0f}ms A: {1e2 * x:.1f} cm B: {1e2 * y:.1f} cm\n"
                   for t, x, y in zip(TIMES, A, B, strict=True))  # fmt: skip
    assert places(text) == {"A": pytest.approx(0.2), "B": pytest.approx(0.9)}
    assert read_measured([text]).tracks[0].t[1] == pytest.approx(TIMES[1])


def test_what_a_monitor_cuts_at_both_ends_is_left_out() -> None:
    text = "Ready\nA:0.3,x_B:0.7\n" + printed(PRINTED["of the plotter"]) + "t:9.99,x_"
    assert places(text) == {"A": pytest.approx(0.2), "B": pytest.approx(0.9)}


def test_words_among_printed_lines_are_refused_with_their_line() -> None:
    lines = printed(PRINTED["of the plotter"]).splitlines()
    with pytest.raises(ReadingError, match=r"line 4: “sensor lost”"):
        read_measured(["\n".join([*lines[:3], "sensor lost", *lines[3:]])])


@pytest.mark.parametrize("word", ["Distance", "Distanz", "Marker", "Decke", "Junge"])
def test_words_that_begin_as_months_do_are_heads(word: str) -> None:
    found = places(table(f"Time,{word} 1,{word} 2", TIMES, A, B))
    assert list(found.values()) == [pytest.approx(0.2), pytest.approx(0.9)]


def test_points_of_coach_are_carts() -> None:
    height = [0.1] * len(TIMES)
    text = table("t (s),P1X (m),P1Y (m),P2X (m),P2Y (m)", TIMES, A, height, B, height)
    assert places(text) == {"P1": pytest.approx(0.2), "P2": pytest.approx(0.9)}


@pytest.mark.parametrize("heads", ["t_ms,x_A_cm,x_B_cm", "time_ms,xA_cm,xB_cm",
                                   "t en ms,x A en cm,x B en cm"])  # fmt: skip
def test_units_behind_a_line_or_en_are_those_of_the_column(heads: str) -> None:
    hundred = ([100.0 * x for x in cart] for cart in (A, B))
    text = table(heads, [1000.0 * t for t in TIMES], *hundred)
    assert list(places(text).values()) == [pytest.approx(0.2), pytest.approx(0.9)]
    assert read_measured([text]).tracks[0].t[1] == pytest.approx(TIMES[1])


def test_a_list_of_single_numbers_is_refused_with_a_sentence() -> None:
    with pytest.raises(ReadingError, match="no row of numbers"):
        read_measured(["£3 NOM VAR\nt\nx1\n£3 GENRE VAR\n0\n0\n£3 UNITE VAR\ns\nm\n"])


@pytest.mark.parametrize("name, first", [("millis", 0.0), ("timestamp", 1.7643312e12)])
def test_milliseconds_that_can_be_nothing_else_need_no_unit(name: str, first: float) -> None:
    text = table(f"{name},x_A (m),x_B (m)", [first + 1000.0 * t for t in TIMES], A, B)
    assert read_measured([text]).tracks[0].t[1] == pytest.approx(TIMES[1], abs=1e-3)


def test_a_time_as_excel_shows_it_is_read_from_minutes_on() -> None:
    rows = zip(TIMES, A, B, strict=True)
    text = "time;x_A;x_B\n" + "".join(f"00:{t:06.3f};{a:.3f};{b:.3f}\n" for t, a, b in rows)
    assert places(text) == {"A": pytest.approx(0.2), "B": pytest.approx(0.9)}
    assert read_measured([text]).tracks[1].t[1] == pytest.approx(TIMES[1])
