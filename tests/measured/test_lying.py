"""A table with a line for each quantity is read as one with a column for each."""

from __future__ import annotations

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured

TIMES = [0.1 * k for k in range(70)]
A = [0.2 + 0.31 * t for t in TIMES]
B = [2.9 - 0.04 * t for t in TIMES]


def lines(separator: str, count: int) -> str:
    rows = {"t (s)": TIMES, "x_A (m)": A, "x_B (m)": B}
    return "\n".join(
        separator.join([name, *(f"{one:.4f}" for one in values[:count])])
        for name, values in rows.items()
    )


@pytest.mark.parametrize("separator", [";", "\t", ","])
@pytest.mark.parametrize("count", [12, 70])
def test_a_table_that_lies_on_its_side_is_read(separator: str, count: int) -> None:
    found = read_measured(["Our third run\n" + lines(separator, count)])
    assert found.names == ("A", "B")
    assert found.tracks[0].value == pytest.approx(A[:count], abs=1e-4)
    assert found.tracks[1].t == pytest.approx(TIMES[:count], abs=1e-4)


def test_a_few_frames_in_lines_of_their_own_are_no_table_on_its_side() -> None:
    with pytest.raises(ReadingError):
        read_measured(["\n".join(f"frame {k};1.0;2.0" for k in range(4))])
