"""A file for each cart: what each of them cannot say, and what must not be guessed."""

from __future__ import annotations

import math

import pytest

from sim.measured.analysis import Wanted, analysed
from sim.measured.tracks import read_measured
from tests.measured.device_reports import known, report
from tests.measured.devices import Motion, sensor_carts

BOUNCE = Motion(v=(0.6, -0.12), ratio=1.4, touch=1.2, lasts=0.3, until=2.6)


def apart(log: str) -> list[str]:
    """A log of both sensors as two files, each with its own time and no name of a cart."""
    rows = [line.split(",") for line in log.splitlines()]
    heads = "Time (s),Position (m),Velocity (m/s),Acceleration (m/s²)"
    return ["\n".join([heads, *(",".join((row[0], *row[k : k + 3])) for row in rows[1:])])
            for k in (1, 4)]  # fmt: skip


@pytest.mark.parametrize("seed", [1, 2])
def test_two_files_of_two_sensors_tell_what_their_one_log_tells(seed: int) -> None:
    log = sensor_carts(BOUNCE, seed)
    one = report(log)
    two = analysed(read_measured(apart(log)), Wanted()).report
    assert two["sensors"].keys() == {"A", "B"}
    for key, row in known(one).items():
        assert known(two)[key]["value"] == pytest.approx(row["value"], rel=1e-9), key
    assert known(two)["v_a"]["value"] == pytest.approx(0.6, abs=0.02)


@pytest.mark.parametrize("swapped", [False, True])
def test_the_first_file_of_two_sensors_is_a_whatever_their_zeros_are(swapped: bool) -> None:
    texts = apart(sensor_carts(BOUNCE))
    first, second = reversed(texts) if swapped else texts
    found = read_measured([first, second])
    assert found.names == ("A", "B") and found.own
    assert found.tracks[0].value == read_measured([first, first]).tracks[0].value


def rows(begin: float, forces: bool = False) -> str:
    push = (4.0 * math.exp(-(((k - 10) / 2) ** 2)) for k in range(20))
    return "".join(f"{k / 20:.3f},{f if forces else begin + 0.01 * k:.5f}\n"
                   for k, f in enumerate(push))  # fmt: skip


@pytest.mark.parametrize(
    "head", ["t,x", "t (s),x (m)", "Time (s),Position (m)", "Zeit (s),Ort (m)"]
)
@pytest.mark.parametrize("places", [(0.3, 0.8), (0.8, 0.3)])
def test_plain_files_without_names_are_a_on_the_left_and_b(
    head: str, places: tuple[float, float]
) -> None:
    found = read_measured([f"{head}\n{rows(place)}" for place in places])
    assert found.names == ("A", "B")
    assert [track.value[0] for track in found.tracks] == [0.3, 0.8]


def test_force_sensors_without_names_are_a_and_b_as_their_files_stand() -> None:
    found = read_measured([f"t (s),Force (N)\n{rows(0.0, forces=True)}" for _ in range(2)])
    assert found.names == ("A", "B")


@pytest.mark.parametrize(
    ("heads", "names"),
    [(("x", "x_A"), ("B", "A")), (("x_B", "x"), ("B", "A")), (("x_C", "x"), ("C", "A")),
     (("x_red", "x_blue"), ("red", "blue")), (("x_A", "x_A"), ("A 1", "A 2"))],
)  # fmt: skip
def test_a_name_that_a_file_gives_is_kept(heads: tuple[str, str], names: tuple[str, str]) -> None:
    texts = [f"t,{head}\n{rows(place)}" for head, place in zip(heads, (0.3, 0.8), strict=True)]
    assert read_measured(texts).names == names
