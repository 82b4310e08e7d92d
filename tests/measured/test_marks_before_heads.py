"""What programs put before or behind the names of columns is no part of them, and no cart."""

from __future__ import annotations

import pytest

from tests.measured.uniform_logs import TIMES, A, B, places, table

MARKED = {
    "numpy's sign": "# t x_B x_A",
    "CASSY's limits": "MIN=0 0 0\nMAX=2 1 1\nSCALE=0 0 0\nDEC=3 3 3\nDEF=t x_B x_A",
    "CASSY's units": 'MIN=0 0 0\nMAX=2 1 1\nDEC=3 3 3\nDEF="t/s" "x_B/m" "x_A/m"',
}


@pytest.mark.parametrize("heads", MARKED.values(), ids=MARKED)
def test_marks_of_programs_before_the_heads_are_no_heads(heads: str) -> None:
    text = table(heads.replace(" ", "\t"), TIMES, B, A).replace(",", "\t")
    assert places(text) == {"A": pytest.approx(0.2), "B": pytest.approx(0.9)}


def test_the_height_of_a_point_is_no_place_on_the_track_with_velocities_beside_it() -> None:
    heads = "Time (s),X (m),Y (m),X Velocity (m/s),Y Velocity (m/s),Object 2 X (m),Object 2 Y (m)"
    height, v = [0.1] * len(TIMES), [0.3] * len(TIMES)
    found = places(table(heads, TIMES, A, height, v, height, B, height))
    assert list(found.values()) == [pytest.approx(0.2), pytest.approx(0.9)]


def test_the_direction_behind_a_cart_does_not_belong_to_its_name() -> None:
    found = places(table("Zeit (s),Wagen B x (m),Wagen A x (m)", TIMES, B, A))
    assert set(found) == {"A", "B"}
