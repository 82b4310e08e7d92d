"""Heads as loggers and teachers write them: whose column it is, which run, which clock."""

from __future__ import annotations

import io
import zipfile

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from sim.measured.units import Units
from sim.measured.zipped import texts_of

TIMES = [0.05 * k for k in range(30)]
A = [0.2 + 0.3 * t for t in TIMES]
B = [0.9 - 0.1 * t for t in TIMES]
SLOW = [0.2 + 0.1 * t for t in TIMES]


def table(heads: str, *columns: list[float]) -> str:
    rows = [",".join(f"{value:.6f}" for value in row) for row in zip(*columns, strict=True)]
    return "\n".join([heads, *rows]) + "\n"


def places(text: str, run: str = "") -> dict[str, float]:
    """The first place of each cart, by its name."""
    return {one.name: one.value[0] for one in read_measured([text], Units(run=run)).tracks}


OWNERS = {
    "before a colon": "Time (s),B: x (m),A: x (m)",
    "a word and a letter": "Time (s),Cart B: Position (m),Cart A: Position (m)",
    "without a colon": "Time (s),Cart B Position (m),Cart A Position (m)",
    "glued": "t,PositionB,PositionA",
    "a word behind": "Time (s),Position of B (m),Position of A (m)",
    "another language": "Masa (s),Kedudukan B (m),Kedudukan A (m)",
}


@pytest.mark.parametrize("how", OWNERS)
def test_a_column_is_of_the_cart_that_its_head_names(how: str) -> None:
    assert places(table(OWNERS[how], TIMES, B, A)) == {"A": A[0], "B": B[0]}


def test_positions_beside_velocities_are_of_the_cart_before_the_colon() -> None:
    heads = "Time (s),A: Position (m),A: Velocity (m/s),B: Position (m),B: Velocity (m/s)"
    still = [0.3] * len(TIMES)
    assert places(table(heads, TIMES, A, still, B, still)) == {"A": A[0], "B": B[0]}


def test_the_place_up_and_down_is_no_second_cart() -> None:
    heads = "Time (s),X Position (m),Y Position (m)"
    with pytest.raises(ReadingError, match="1 cart"):
        read_measured([table(heads, TIMES, A, B)])


@pytest.mark.parametrize("label", ["Run", "Data Set", "Lauf"])
def test_two_runs_of_one_cart_are_not_two_carts(label: str) -> None:
    heads = f"{label} 1:Time(s),{label} 1:Position(m),{label} 2:Time(s),{label} 2:Position(m)"
    with pytest.raises(ReadingError, match="readings of 1 cart"):
        read_measured([table(heads, TIMES, A, TIMES, SLOW)])


def test_of_several_runs_with_both_forces_one_is_read() -> None:
    heads = ",".join(f"Run {k}: {h}" for k in (3, 5) for h in ("Time (s)", "F_A (N)", "F_B (N)"))
    text = table(heads, TIMES, A, B, TIMES, SLOW, B)
    first, asked = read_measured([text]), read_measured([text], Units(run="5"))
    assert first.kind == asked.kind == "force"
    assert first.runs == ("3", "5")
    assert "run 3 is read; other runs in the file: 5" in first.notes
    assert first.tracks[0].value[-1] == pytest.approx(A[-1])
    assert asked.tracks[0].value[-1] == pytest.approx(SLOW[-1])
    assert read_measured([text], Units(run="2")).tracks == asked.tracks  # by its place
    with pytest.raises(ReadingError, match=r"no run 4: this file has 2\n.*3, 5"):
        read_measured([text], Units(run="4"))


def test_runs_named_above_the_heads_are_no_tracks() -> None:
    heads = "Run #1,,,Run #2,,\nTime (s),x_A (m),x_B (m),Time (s),x_A (m),x_B (m)"
    text = table(heads, TIMES, A, B, TIMES, SLOW, B)
    assert read_measured([text]).tracks[0].value[-1] == pytest.approx(A[-1])
    assert read_measured([text], Units(run="2")).tracks[0].value[-1] == pytest.approx(SLOW[-1])


def test_each_sensor_has_the_clock_to_its_left() -> None:
    late = [t + 0.01 for t in TIMES]
    found = read_measured([table("Time 1 (s),x_1 (m),Time 2 (s),x_2 (m)", TIMES, A, late, B)])
    assert [one.t[0] for one in found.tracks] == pytest.approx([0.0, 0.01])


def test_two_files_of_one_force_sensor_each_are_both_sensors() -> None:
    files = [table("Time (s),Force (N)", TIMES, values) for values in (A, B)]
    found = read_measured(files)
    assert found.kind == "force"
    assert len({*found.names}) == 2
    with pytest.raises(ReadingError, match="readings of 1 force sensor"):
        read_measured(files[:1])


@pytest.mark.parametrize("heads", ["t,v_A,v_B", "t,a_A,a_B", "Zeit,Geschwindigkeit A,v B"])
def test_velocities_without_a_unit_are_not_read_as_places(heads: str) -> None:
    with pytest.raises(ReadingError, match="has no unit and is no place"):
        read_measured([table(heads, TIMES, A, B)])


@pytest.mark.parametrize(
    "heads", ["Time (s),Force (N),Force (N)", "Time (s),Force1 (N),Force2 (N)"]
)
def test_names_are_whole_words(heads: str) -> None:
    names = read_measured([table(heads, TIMES, A, B)]).names
    assert not any("orce" in name for name in names)


def test_a_remark_in_a_zip_is_not_taken_for_the_table() -> None:
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as pack:
        pack.writestr("README.txt", "Made in class\n")
        pack.writestr("run.csv", table("t,x_A,x_B", TIMES, A, B))
    assert places(*texts_of(content.getvalue())) == {"A": A[0], "B": B[0]}
