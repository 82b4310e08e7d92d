"""Columns are known by their units and by the words of many languages; clocks count seconds."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.sheet.clock import seconds_of
from sim.measured.sheet.heads import quantity_of
from sim.measured.tracks import read_measured
from sim.measured.units import head
from tests.measured.devices import Motion, motion_capture

TIMES = [0.1 * k for k in range(12)]
A = [0.2 + 0.31 * t for t in TIMES]
B = [0.9 - 0.04 * t for t in TIMES]
SPEEDS = (0.31, -0.04)

HEADS = {
    "German": ("Zeit (s)", "Position {} (m)", "Geschwindigkeit {} (m/s)"),
    "French": ("Temps (s)", "Position {} (m)", "Vitesse {} (m/s)"),
    "Spanish": ("Tiempo (s)", "Posición {} (m)", "Velocidad {} (m/s)"),
    "Chinese": ("时间 (s)", "位置 {} (m)", "速度 {} (m/s)"),
    "wide brackets": ("时间（s）", "位置{}（m）", "速度{}（m/s）"),
    "Malay": ("Masa (s)", "Kedudukan {} (m)", "Halaju {} (m/s)"),
    "Tamil": ("நேரம் (s)", "நிலை {} (m)", "திசைவேகம் {} (m/s)"),
    "other letters": ("Время (с)", "Положение {} (м)", "Скорость {} (м/с)"),
    "letters": ("t/s", "x_{}/m", "v_{}/(m/s)"),
    "unknown words": ("Ttt (s)", "Foo {} (m)", "Bar {} (m/s)"),
}


def table(heads: list[str], *columns: list[float] | list[str]) -> str:
    rows = [";".join(map(str, row)) for row in zip(*columns, strict=True)]
    return "\n".join([";".join(heads), *rows]) + "\n"


@pytest.mark.parametrize("language", HEADS)
def test_positions_beside_velocities_are_found_in(language: str) -> None:
    time, place, speed = HEADS[language]
    v = [[one] * len(TIMES) for one in SPEEDS]
    heads = [time, *(form.format(n) for n in (1, 2) for form in (place, speed))]
    found = read_measured([table(heads, TIMES, A, v[0], B, v[1])])
    assert found.names == ("1", "2")
    assert found.tracks[0].value == pytest.approx(A)
    assert found.tracks[1].value == pytest.approx(B)


@pytest.mark.parametrize(
    ("unit", "metres"), [("m/s", 1.0), ("cm/s", 0.01), ("mm/s", 1e-3), ("km/h", 1 / 3.6)]
)
def test_velocities_alone_are_summed_up_in(unit: str, metres: float) -> None:
    v = [[one / metres] * len(TIMES) for one in SPEEDS]
    found = read_measured([table(["t (s)", f"v_A ({unit})", f"v_B ({unit})"], TIMES, *v)])
    assert found.names == ("A", "B")
    for track, x in zip(found.tracks, (A, B), strict=True):
        assert [value - track.value[0] for value in track.value] == pytest.approx(
            [value - x[0] for value in x], abs=1e-9
        )


CLOCKS = {
    "time of day": "10:17:{:06.3f}",
    "comma": "10:17:{:06.3f}",
    "date and time": "2026-11-23T10:17:{:06.3f}Z",
    "European date": "23.11.2026 10:17:{:06.3f}",
    "American date": "11/23/2026 10:17:{:06.3f} am",
}


@pytest.mark.parametrize("kind", CLOCKS)
def test_a_clock_counts_from_the_first_reading(kind: str) -> None:
    cells = [CLOCKS[kind].format(33.25 + t) for t in TIMES]
    cells = [cell.replace(".", ",") for cell in cells] if kind == "comma" else cells
    found = read_measured([table(["Zeit", "x_A (m)", "x_B (m)"], cells, A, B)])
    assert found.tracks[0].t == pytest.approx(TIMES, abs=1e-6)
    assert any("counts from the first reading" in note for note in found.notes)
    assert any("t in s (as the file says)" in note for note in found.notes)


def test_seconds_since_1970_count_from_the_first_reading() -> None:
    late = [1.7e9 + t for t in TIMES]
    found = read_measured([table(["t (s)", "x_A (m)", "x_B (m)"], late, A, B)])
    assert found.tracks[0].t == pytest.approx(TIMES, abs=1e-6)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("11:59:59 AM", "12:00:00 PM"),
        ("12:59:59 p.m.", "1:00:00 p.m."),
        ("12:00:00 AM", "12:00:01 am"),
        ("12:59:59 AM", "1:00:00 AM"),
    ],
)
def test_noon_is_twelve_pm_and_midnight_twelve_am(before: str, after: str) -> None:
    one, next_one = seconds_of(before), seconds_of(after)
    assert one is not None and next_one is not None
    assert next_one - one == 1.0
    assert seconds_of("12:00:00 AM") == 0.0


def test_what_is_no_time_of_day_is_none() -> None:
    for cell in ("10:17", "25:00:00", "10:61:00", "10:17:99", "1.5", "", "a:b:c"):
        assert seconds_of(cell) is None


def test_a_place_that_is_too_large_is_refused_with_its_line() -> None:
    with pytest.raises(ReadingError, match="line 4: 2e\\+12 is too large"):
        read_measured([table(["t (s)", "x_A (m)", "x_B (m)"], TIMES, [*A[:2], 2e12, *A[3:]], B)])


def test_running_numbers_under_a_cross_are_no_remark() -> None:
    counts = [str(k) for k in range(len(TIMES))]
    found = read_measured([table(["#", "t (s)", "x_A (m)", "x_B (m)"], counts, TIMES, A, B)])
    assert found.tracks[0].value == pytest.approx(A)


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("v_B (km/h)", ("vel", "B")),
        ("Position, Ch 2 (m)", ("pos", "2")),
        ("Acceleration 1 (m/s²)", ("acc", "1")),
        ("Acceleration 1 (m/s^2)", ("acc", "1")),
        ("x", ("pos", "")),
        ("Cart 2 (cm)", ("pos", "2")),
        ("colour", (None, "")),
    ],
)
def test_a_head_tells_quantity_and_cart(text: str, wanted: tuple[str | None, str]) -> None:
    assert quantity_of(*head(text)) == wanted


def with_third(text: str, floor: bool) -> str:
    """A third marker: on the floor, or 40 mm beside the second one on its cart."""
    lines = []
    for line in text.splitlines():
        cells = line.split("\t")
        if cells[0] == "MARKER_NAMES":
            cells.append("third")
        elif len(cells) == 6:
            x, y, z = map(float, cells[3:])
            cells += (
                ["77.0", "21.0", "3.0"] if floor else [f"{x + 32:.3f}", f"{y + 24:.3f}", str(z)]
            )
        lines.append("\t".join(cells))
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("floor", [True, False])
def test_of_three_markers_two_that_move_apart_are_taken(floor: bool) -> None:
    text = motion_capture(Motion(until=2.0), swapped=200)
    plain, found = read_measured([text]), read_measured([with_third(text, floor)])
    assert any("left out" in note for note in found.notes)
    shifts = [
        {round(a - b, 3) for a, b in zip(one.value, two.value, strict=True)}
        for one, two in zip(plain.tracks, found.tracks, strict=True)
    ]
    assert all(max(shift) - min(shift) < 0.002 for shift in shifts)


def with_frames(text: str, *, empty_until: int, head: bool) -> str:
    """With frame and time in front; the second marker is hidden, and empty, in the first frames."""
    lines, k = [], 0
    for line in text.splitlines():
        cells = line.split("\t")
        if len(cells) == 6 and cells[0][0].isdigit():
            if k < empty_until:
                cells[3:] = ["", "", ""]
            lines.append("\t".join([str(k + 1), f"{k / 250:.5f}", *cells]))
            k += 1
            continue
        if head and k == 0 and cells[0] == "TRAJECTORY_TYPES":
            lines.append("Frame\tTime\tNew 0000 X\tY\tZ\tNew 0001 X\tY\tZ")
        lines.append(line)
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize("head", [True, False])
@pytest.mark.parametrize("empty_until", [0, 3])
def test_a_marker_that_is_hidden_at_first_moves_no_columns(head: bool, empty_until: int) -> None:
    text = motion_capture(Motion(until=2.0))
    plain = read_measured([text])
    found = read_measured([with_frames(text, empty_until=empty_until, head=head)])
    for one, two in zip(plain.tracks, found.tracks, strict=True):
        assert two.value[-1] - two.value[5] == pytest.approx(one.value[-1] - one.value[5], abs=1e-3)


@pytest.mark.parametrize(
    ("time", "place"),
    [
        ("t s", "{} cm"),
        ("t, s", "{}, cm"),
        ("t (in s)", "{} (in cm)"),
        ("Zeit in Sekunden", "{} in Zentimeter"),
        ("time [seconds]", "{} [centimetres]"),
        ("| t (s)", "{} (cm)"),
    ],
)
def test_a_unit_that_stands_in_a_head_in_whatever_way_is_read(time: str, place: str) -> None:
    centimetres = [[100.0 * x for x in xs] for xs in (A, B)]
    text = table([time, place.format("A"), place.format("B")], TIMES, *centimetres)
    if time.startswith("|"):  # as Markdown writes tables
        head, *rows = text.strip().split("\n")
        text = "\n".join(
            row.replace(";", "|")
            for row in (head, "| :---;---:;---:", *(f"| {row}" for row in rows))
        )
    found = read_measured([text])
    assert found.names == ("A", "B")
    assert found.tracks[0].value == pytest.approx(A)
    assert found.tracks[1].value == pytest.approx(B)


def test_a_word_behind_a_comma_or_in_brackets_that_is_no_unit_stays_in_the_name() -> None:
    assert head("Run 1, x") == ("Run 1, x", "")
    assert head("Smart Cart s") == ("Smart Cart s", "")
    assert head("x (in)") == ("x", "in")
