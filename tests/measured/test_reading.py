"""Files as Tracker, spreadsheets and sensors write them, and files that nobody can use."""

from __future__ import annotations

import pytest

from sim.measured.sheet.cells import decoded
from sim.measured.tracks import Measured, read_measured
from sim.measured.units import Units
from tests.measured.written_films import PLAIN, VARIANTS, A, B, T, rows, with_y


def same(found: Measured) -> None:
    assert found.kind == "length"
    for track, t, x in zip(found.tracks, (T, T), (A, B), strict=True):
        assert track.t == pytest.approx(t, abs=2e-9)
        assert track.value == pytest.approx(x, abs=2e-9)


@pytest.mark.parametrize("name", VARIANTS)
def test_every_way_of_writing_gives_the_same_readings(name: str) -> None:
    same(read_measured([VARIANTS[name]]))


def test_two_files_with_a_track_each_are_two_carts() -> None:
    one, two = (
        f"mass_{n}\nt\tx\ty\n"
        + "".join(f"{t:.9E}\t{v:.9E}\t0\n" for t, v in zip(T, x, strict=True))
        for n, x in (("A", A), ("B", B))
    )
    found = read_measured([two, one])
    same(found)
    assert found.names == ("A", "B")


def test_names_of_tracks_are_the_names_of_the_carts() -> None:
    assert read_measured([with_y().replace("mass_", "van ")]).names == ("van A", "van B")
    assert read_measured([VARIANTS["CSV"]]).names == ("A", "B")


@pytest.mark.parametrize(
    ("written", "names"),
    [
        (("mass_A", "mass_B"), ("A", "B")),
        (("masa A", "masa B"), ("A", "B")),
        (("mass A", "wagon"), ("mass A", "wagon")),
        (("mass 1", "masse 1"), ("mass 1", "masse 1")),  # else both were one
    ],
)
def test_what_tracker_calls_its_points_is_no_part_of_a_carts_name(
    written: tuple[str, str], names: tuple[str, str]
) -> None:
    text = with_y().replace("mass_A", written[0]).replace("mass_B", written[1])
    assert read_measured([text]).names == names


def test_a_logger_s_two_forces_are_two_sensors() -> None:
    for heads in (
        "Latest: Time (s)\tLatest: Force (N)\tLatest: Force 2 (N)\n",
        "Time (s) Run #1\tForce, A (N) Run #1\tForce, B (N) Run #1\n",
    ):
        assert read_measured([heads + rows("\t")]).kind == "force"


def test_utf_16_is_read_by_its_mark() -> None:
    same(read_measured([decoded(PLAIN.encode("utf-16"))]))


def test_units_of_the_file_are_taken_before_the_readers() -> None:
    text = "t (ms);x_A (cm);x_B (cm)\n" + "".join(
        f"{1e3 * t:.9f};{1e2 * a:.9f};{1e2 * b:.9f}\n" for t, a, b in zip(T, A, B, strict=True)
    )
    same(read_measured([text], Units(time="s", length="mm")))
    found = read_measured(["t;x_A;x_B\n" + rows(";")], Units(time="ms", length="cm"))
    assert found.tracks[0].t[-1] == pytest.approx(T[-1] / 1e3)
    assert found.tracks[1].value[0] == pytest.approx(B[0] / 1e2)
    assert found.assumed == {"time", "length"}


def test_columns_of_unequal_length_keep_what_each_cart_has() -> None:
    lines = PLAIN.splitlines()
    for k in range(20, len(lines)):
        cells = lines[k].split("\t")
        lines[k] = "\t".join([*cells[:3], "", "", ""])
    found = read_measured(["\n".join(lines)])
    assert len(found.tracks[0].t) == len(T)
    assert len(found.tracks[1].t) == 17


def test_two_force_columns_are_two_sensors() -> None:
    text = "t (s);F_A (N);F_B (N)\n" + rows(";")
    found = read_measured([text])
    assert found.kind == "force"
    assert found.names == ("A", "B")


def test_metres_in_three_decimals_with_a_comma_are_no_thousands() -> None:
    lines = "".join(f"0,{20 + k}0\t1,{300 + k}\t1,{900 - k}\n" for k in range(30))
    found = read_measured(["t\tx_A\tx_B\n" + lines])
    assert found.tracks[0].value[0] == 1.3
