"""The unit of a column, wherever its head says it; and what no head makes of a column."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from sim.measured.units import Units, head
from tests.measured.device_reports import LOGGED
from tests.measured.devices import phone, sensor_carts
from tests.measured.written_films import is_the_film, table

G = 9.80665
LOG = sensor_carts(LOGGED).removeprefix("\ufeff").replace('"', "")


@pytest.mark.parametrize("form", [
    "Position (cm) {}", "x (cm) {}", "x [cm] {}", "Position(cm) {}", "Position (cm) Ch {}",
    "Position （cm） {}", "Ort (cm) {}", "Position (in cm) {}",
])  # fmt: skip
@pytest.mark.parametrize("carts", [("A", "B"), ("1", "2")])
def test_a_unit_in_the_middle_of_a_head_is_its_unit(form: str, carts: tuple[str, str]) -> None:
    found = read_measured([table(",".join(["t (s)", *map(form.format, carts)]), size=0.01)])
    assert found.names == carts
    assert is_the_film(found) and not found.assumed


@pytest.mark.parametrize("text", ["Position (left) A", "Position(s) A", "x (cm) of the red cart",
                                  "x (1) A"])  # fmt: skip
def test_what_is_no_unit_stays_in_the_name(text: str) -> None:
    assert "cm" not in head(text)[1] and head(text)[1] != "s"


def test_velocities_and_accelerations_have_their_units_in_the_middle_too() -> None:
    assert head("Velocity (cm/s) A") == ("Velocity A", "cm/s")
    assert head("Acceleration (m/s^2) x") == ("Acceleration x", "m/s^2")


@pytest.mark.parametrize(("name", "unit"), [
    ("t_us", 1e-6), ("time_us", 1e-6), ("Time_us", 1e-6), ("micros", 1e-6), ("micros()", 1e-6),
    ("time_ns", 1e-9), ("t_min", 60.0), ("t_ms", 1e-3), ("millis", 1e-3), ("Time (us)", 1e-6),
    ("t (µs)", 1e-6), ("t (μs)", 1e-6), ("elapsed_ms", 1e-3), ("time_s", 1.0),
    ("timestamp_us", 1e-6),
])  # fmt: skip
def test_a_clock_is_read_in_the_unit_that_its_name_tells(name: str, unit: float) -> None:
    found = read_measured([table(f"{name},x_A (m),x_B (m)", clock=unit)])
    assert is_the_film(found) and not found.assumed


@pytest.mark.parametrize(("unit", "size"), [("µs", 1e-6), ("min", 60.0)])
def test_a_reader_may_say_that_times_are_in_microseconds_or_minutes(unit: str, size: float) -> None:
    assert is_the_film(read_measured([table("t,x_A (m),x_B (m)", clock=size)], Units(time=unit)))


@pytest.mark.parametrize("name", ["Time (ms)", "Time (hh:mm:ss)", "Time (hh:mm:ss.000)", "t_min",
                                  "Zeit [hh:mm:ss]", "Time"])  # fmt: skip
@pytest.mark.parametrize("log", [False, True])
def test_times_of_day_are_seconds_whatever_their_head_says(name: str, log: bool) -> None:
    lines = (LOG if log else table("t,x_A (m),x_B (m)")).splitlines()
    seconds = [float(line.split(",")[0]) for line in lines[1:]]
    cells = [f"10:17:{s + 10:09.6f},{line.split(',', 1)[1]}"
             for s, line in zip(seconds, lines[1:], strict=True)]  # fmt: skip
    found = read_measured(["\n".join([f"{name},{lines[0].split(',', 1)[1]}", *cells])])
    t = found.tracks[0].t
    assert [one - t[0] for one in t] == pytest.approx([s - seconds[0] for s in seconds], abs=2e-6)
    assert "time" not in found.assumed


@pytest.mark.parametrize("heads", [
    "Time (s),Position A (cm),Velocity A (m/s),Acc,Position B,Velocity B (m/s),Acc2",
    "Time (s),q,Velocity A (m/s),q1,q2,Velocity B,q3",
])  # fmt: skip
def test_one_column_of_a_log_with_a_unit_and_the_other_without_is_refused(heads: str) -> None:
    with pytest.raises(ReadingError, match="one column names its unit and the other does not"):
        read_measured(["\n".join([heads, *LOG.splitlines()[1:]])])


def in_units(text: str, unit: str, size: float, clock: str, second: float) -> str:
    heads, *lines = text.removeprefix("\ufeff").splitlines()
    cells = ([float(cell) for cell in line.split(",")] for line in lines)
    rows = (",".join(f"{v:.12f}" for v in (t / second, *(a / size for a in parts)))
            for t, *parts in cells)  # fmt: skip
    return "\n".join([heads.replace("m/s^2", unit).replace("(s)", f"({clock})"), *rows])


@pytest.mark.parametrize(("unit", "size"), [
    ("G", G), ("g", G), ("mg", 1e-3 * G), ("cm/s^2", 0.01), ("cm/s²", 0.01), ("mm/s²", 1e-3),
    ("m s⁻²", 1.0), ("m/s²", 1.0),
])  # fmt: skip
@pytest.mark.parametrize(("clock", "second"), [("s", 1.0), ("us", 1e-6), ("ns", 1e-9)])
def test_a_phone_is_read_in_the_units_that_its_heads_name(
    unit: str, size: float, clock: str, second: float
) -> None:
    texts = [phone(LOGGED, k, seed=k) for k in (0, 1)]
    wanted = read_measured(texts)
    found = read_measured([in_units(one, unit, size, clock, second) for one in texts])
    for one, other in zip(found.tracks, wanted.tracks, strict=True):
        assert one.t == pytest.approx(other.t, abs=1e-9)
        assert one.value == pytest.approx(other.value, abs=1e-6)


@pytest.mark.parametrize(("unit", "clock"), [("ft/s²", "s"), ("V", "s"), ("m/s^2", "ticks")])
def test_a_phone_in_a_unit_that_is_none_of_these_is_refused_with_those_that_are(
    unit: str, clock: str
) -> None:
    with pytest.raises(ReadingError, match="is no unit that fits") as caught:
        read_measured([in_units(phone(LOGGED, 0), unit, 1.0, clock, 1.0)])
    assert caught.value.faults[0].hint


def test_a_last_line_of_empty_quoted_cells_is_no_row() -> None:
    heads, *lines = table("t,x_A,x_B").splitlines()
    quoted = [",".join(f'"{cell}"' for cell in line.split(",")) for line in [heads, *lines, ",,"]]
    assert is_the_film(read_measured(["\n".join(quoted)]))
