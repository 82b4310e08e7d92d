"""Dates with times, and units inside of cells: read, or refused with the line and the reason."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from tests.measured.written_films import A, B, T, decimal_comma

DATES = {
    "day first": "26/11/2026 10:17:{:09.6f}",
    "month first": "11/26/2026 10:17:{:09.6f}",
    "a short year": "26/11/26 10:17:{:09.6f}",
    "a comma behind the date": "26/11/2026, 10:17:{:09.6f}",
    "dots": "26.11.2026 10:17:{:09.6f}",
    "year first": "2026-11-26 10:17:{:09.6f}",
    "year first with slashes": "2026/11/26 10:17:{:09.6f}",
}


def film(date: str, separator: str, number: str = "{:.9f}") -> str:
    rows = [
        separator.join((date.format(10.0 + t), number.format(a), number.format(b)))
        for t, a, b in zip(T, A, B, strict=True)
    ]
    return "\n".join([separator.join(("t", "x_A", "x_B")), *rows]) + "\n"


@pytest.mark.parametrize("separator", [",", ";", "\t", " "], ids=["comma", ";", "tab", "space"])
@pytest.mark.parametrize("date", DATES.values(), ids=DATES)
def test_a_date_with_its_time_is_read_from_the_first_reading_on(date: str, separator: str) -> None:
    if separator == "," and "," in date:
        date = f'"{date}"'
    first, second = read_measured([film(date, separator)]).tracks
    assert [t - first.t[0] for t in first.t] == pytest.approx([t - T[0] for t in T], abs=2e-6)
    assert first.value == pytest.approx(A, abs=1e-8)
    assert second.value == pytest.approx(B, abs=1e-8)


def test_a_half_of_the_day_stands_in_the_cell_of_its_time() -> None:
    found = read_measured([film("11/26/2026 10:17:{:09.6f} AM", ",")])
    assert found.tracks[0].value == pytest.approx(A, abs=1e-8)


def test_decimal_commas_between_spaces_are_no_columns() -> None:
    found = read_measured([decimal_comma(film("{:.6f}", " "))])
    assert found.tracks[1].value == pytest.approx(B, abs=1e-8)
    assert "space between the columns, decimal comma" in found.notes


@pytest.mark.parametrize(
    ("date", "number", "reason"),
    [
        ("26/11/2026 10:17", "{:.9f}", "“26/11/2026 10:17” is not a number"),
        ("26/11/2026 10:17:33", "{:.9f}", "the time stands in line 2 already"),
        ("{:.6f}", "{:.4f} m", "a unit stands in a cell: “"),
        ("{:.6f} s", "{:.4f} m", "a unit stands in a cell: “"),
        ("{:.6f}", "{:.4f}cm", "a unit stands in a cell: “"),
    ],
)
@pytest.mark.parametrize("separator", [",", "\t"], ids=["comma", "tab"])
def test_what_is_no_reading_in_a_cell_is_named_with_its_line(
    date: str, number: str, reason: str, separator: str
) -> None:
    with pytest.raises(ReadingError) as caught:
        read_measured([film(date, separator, number)])
    fault = caught.value.faults[0]
    assert fault.line == (3 if "already" in reason else 2)
    assert reason in fault.reason


def test_units_between_spaces_are_told_not_to_stand_in_cells() -> None:
    with pytest.raises(ReadingError) as caught:
        read_measured([film("{:.6f}", " ", "{:.4f} m")])
    assert "no cell a unit" in caught.value.faults[0].hint


@pytest.mark.parametrize(("head", "metres"), [
    ("x_{} (in)", 0.0254), ("x_{}/in", 0.0254), ("x_{} (inches)", 0.0254),
    ("x_{} in inches", 0.0254), ("x_{} (ft)", 0.3048), ("x_{} in feet", 0.3048),
    ("x_{} in centimetres", 0.01), ("x_{} in millimeters", 1e-3),
])  # fmt: skip
def test_inches_feet_and_units_written_out_are_read(head: str, metres: float) -> None:
    rows = "\n".join(f"{t:.9f},{a:.9f},{b:.9f}" for t, a, b in zip(T, A, B, strict=True))
    text = f"t (s),{head.format('A')},{head.format('B')}\n{rows}\n"
    first, second = read_measured([text]).tracks
    assert first.value == pytest.approx([metres * a for a in A])
    assert second.value == pytest.approx([metres * b for b in B])
    assert (first.name, second.name) == ("A", "B")
