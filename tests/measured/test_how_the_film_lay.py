"""A film lies as the camera lay: what counts is the way along the track, not x of the picture."""

from __future__ import annotations

import math
from collections.abc import Sequence
from random import Random

import pytest

from sim.measured.tracks import Measured, read_measured
from tests.measured.devices import Motion, tracker_project
from tests.measured.makers import film, truth

STEP = 2e-3
"""m. Twice what the marks scatter by below: one place on the track."""

WANTED = film(truth(), rate=60, noise=0.0)
T = WANTED.tracks[0].t
A, B = (track.value for track in WANTED.tracks)
HEADS = {
    "tracker": "#multi:\n,mass A,,mass B,\nt,x,y,x,y\n",
    "one head": "t,x_A,y_A,x_B,y_B\n",
    "glued, with units": "t (s),xA (m),yA (m),xB (m),yB (m)\n",
    "behind a point": "t,A.x,A.y,B.x,B.y\n",
}


def table(degrees: float, heads: str = HEADS["tracker"], height: float = 0.04) -> str:
    """The film turned by so much; marks scatter by 1 mm, B's is `height` m higher on its cart."""
    random = Random(3)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    rows = []
    for t, a, b in zip(T, A, B, strict=True):
        row = [t]
        for x, up in ((a, 0.0), (b, height)):
            y = up + random.gauss(0.0, 1e-3)
            row += [x * c - y * s + 0.1, x * s + y * c + 0.2]
        rows.append(",".join(f"{value:.6f}" for value in row))
    return heads + "\n".join(rows) + "\n"


def way(measured: Measured, k: int = 0) -> list[float]:
    value = measured.tracks[k].value
    return [x - value[0] for x in value]


def gone(wanted: Sequence[float]) -> list[float]:
    return [x - wanted[0] for x in wanted]


@pytest.mark.parametrize("heads", HEADS.values(), ids=HEADS)
@pytest.mark.parametrize("degrees", [-40.0, 12.0, 45.0, 88.0, 90.0])
def test_a_film_may_lie_askew(degrees: float, heads: str) -> None:
    found = read_measured([table(degrees, heads)])
    assert way(found, 0) == pytest.approx(gone(A), abs=STEP)
    assert way(found, 1) == pytest.approx(gone(B), abs=STEP)
    assert any("direction of the track" in note for note in found.notes)


def test_a_film_in_which_carts_go_down_has_plus_upwards() -> None:
    found = read_measured([table(-90.0)])
    assert way(found, 1) == pytest.approx([-x for x in gone(A)], abs=STEP)
    assert found.names == ("B", "A")


@pytest.mark.parametrize("degrees", [-2.5, 0.0, 2.5])
def test_along_x_nothing_is_turned(degrees: float) -> None:
    """And marks at two heights turn nothing either."""
    text = table(degrees, height=0.2)
    xs = [float(line.split(",")[1]) for line in text.splitlines()[3:]]
    found = read_measured([text])
    assert list(found.tracks[0].value) == xs
    assert not any("direction" in note for note in found.notes)


def test_two_files_of_one_film_are_turned_alike() -> None:
    lines = [line.split(",") for line in table(60.0, HEADS["one head"]).splitlines()]
    one, other = (
        "\n".join(",".join(row[k] for k in (0, i, i + 1)) for row in lines) + "\n" for i in (1, 3)
    )
    found = read_measured([one, other])
    assert way(found, 0) == pytest.approx(gone(A), abs=STEP)
    assert way(found, 1) == pytest.approx(gone(B), abs=STEP)


def test_pucks_that_leave_the_line_are_read_along_x_and_it_is_said() -> None:
    lines = HEADS["one head"]
    for k in range(40):
        t, hit = k / 60, max(0.0, k / 60 - 0.3)
        lines += f"{t:.4f},{0.6 * t - 0.5 * hit:.4f},{0.2 + 0.25 * hit:.4f}"
        lines += f",{0.3 + 0.5 * hit:.4f},{0.22 - 0.25 * hit:.4f}\n"
    found = read_measured([lines])
    assert max(found.tracks[0].value) == pytest.approx(0.6 * 0.3 + 0.1 * (39 / 60 - 0.3), abs=1e-3)
    assert any("do not stay on one line" in note for note in found.notes)


def test_a_project_whose_axes_nobody_turned_is_read_along_the_track() -> None:
    made = Motion()
    turned = tracker_project(made).replace('type="double">2.0<', 'type="double">-58.0<')
    wanted = read_measured([tracker_project(made)])
    found = read_measured([turned])
    for k in (0, 1):
        assert way(found, k) == pytest.approx(way(wanted, k), abs=1e-3)
