"""Heads as loggers and teachers write them: whose column it is, which run, which clock."""

from __future__ import annotations

import io
import re
import zipfile

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from sim.measured.units import Units
from sim.measured.zipped import texts_of
from tests.measured.uniform_logs import SLOW, TIMES, A, B, places, table

PLACES = """\
Time (s)|B: x (m)|A: x (m)
Time (s)|Cart B: Position (m)|Cart A: Position (m)
Time (s)|Cart B Position (m)|Cart A Position (m)
Time (s)|Cart B: Position|Cart A: Position
t|PositionB|PositionA
t|x of B|x of A
t|position of cart B|position of cart A
Time (s)|Position of B (m)|Position of A (m)
Masa (s)|Kedudukan B (m)|Kedudukan A (m)
t|B.x|A.x
t|x_B_run1|x_A_run1
t|B|A
B: Time (s)|B: x (m)|A: Time (s)|A: x (m)
Group 3: t|Group 3: x_B|Group 3: x_A
Time (s)|B Position (m)|A Position (m)|A y (m)
t|x: B|x: A
Time (s)|B: s (m)|A: s (m)
t|x_B|x_A|v_x
t|x_B|x_A|acceleration x"""
NAMES = {
    "t|Cart A|Cart B": "Cart A, Cart B",
    "t|小车 A|小车 B": "小车 A, 小车 B",
    "t|a1|a2": "a1, a2",
    "t|a_x|b_x": "a, b",
    "t|xLeft|xRight": "Left, Right",
    "t|Position|Position 2": "1, 2",
    "t (s)|Smart Cart Red 12-34 Position (m)|Smart Cart Blue 7 Position (m)": "Red 12-34, Blue 7",
    "Latest: Time (s)|Latest: Position (m)|Latest: Position 2 (m)": "1, 2",
}
FORCES = {
    "t|Dual Range Force 1|Dual Range Force 2": "1, 2",
    "t|Dual Range Force|Dual Range Force 2": "1, 2",
    "t|Force on A|Force on B": "A, B",
    "t|Kraft auf A|Kraft auf B": "A, B",
    "Collision:Time(s)|Collision:Force 1(N)|Collision:Force 2(N)": "1, 2",
    "Versuch 1: t|Versuch 1: F_A|Versuch 1: F_B": "A, B",
    "Time (s)|Force (N), Run #1|Force 2 (N), Run #1": "1, 2",
    "Time (s)|Left (N)|Right (N)": "Left, Right",
    "Time (s)|B: Force (N)|A: Force (N)": "B, A",
    "Time (s)|Cart B Force (N)|Cart A Force (N)": "B, A",
    "t|B_F|A_F": "B, A",
    "t|F: B|F: A": "B, A",
    "Time (s)|Red: Force (N)|Blue: Force (N)": "Red, Blue",
    "Time (s)|Force on B by A (N)|Force on A by B (N)": "B, A",
    "Time (s)|force by A on B (N)|force by B on A (N)": "B, A",
    "A: t|A: F|B: t|B: F": "A, B",
}


CLOCK = re.compile(r"(?:.*:\s*)?(?:t|Time ?\(s\)|Masa \(s\)|t \(s\))")


def written(heads: str) -> str:
    """A table below these heads: B's places, then A's, where they are places."""
    cells, others = heads.split("|"), iter((B, A, SLOW))
    timed = [CLOCK.fullmatch(cell) is not None for cell in cells]
    return table(",".join(f'"{cell}"' for cell in cells),
                 *(TIMES if time else next(others) for time in timed))  # fmt: skip


@pytest.mark.parametrize("heads", PLACES.splitlines())
def test_a_column_is_of_the_cart_that_its_head_names(heads: str) -> None:
    assert places(written(heads)) == {"A": A[0], "B": B[0]}


@pytest.mark.parametrize("heads", NAMES)
def test_carts_are_called_as_the_heads_tell_them_apart(heads: str) -> None:
    found = read_measured([written(heads)])
    assert found.kind == "length"
    assert sorted(found.names) == sorted(NAMES[heads].split(", "))


@pytest.mark.parametrize("heads", FORCES)
def test_a_force_is_no_place_whatever_stands_around_it(heads: str) -> None:
    found = read_measured([written(heads)])
    assert (found.kind, ", ".join(found.names)) == ("force", FORCES[heads])


@pytest.mark.parametrize("label", ["Datensatz {}", "Trial {}", "Essai n° {}", "Anna {}"])
def test_datasets_with_a_time_of_their_own_are_runs_whatever_they_are_called(label: str) -> None:
    heads = [f"{label.format(k)}: {h}" for k in (1, 2) for h in ("t", "x_A", "x_B")]
    text = table(",".join(heads), TIMES, A, B, TIMES, SLOW, B)
    found = read_measured([text])
    assert len(found.runs) == 2
    assert found.names == ("A", "B")
    asked = read_measured([text], Units(run="2"))
    assert asked.tracks[0].value[-1] == pytest.approx(SLOW[-1])


def test_the_only_run_of_a_file_may_be_asked_for_as_it_is_called() -> None:
    text = table("Run 3: t,Run 3: x_A,Run 3: x_B", TIMES, A, B)
    assert read_measured([text], Units(run="3")).tracks == read_measured([text]).tracks


def test_tracks_that_are_called_like_runs_stay_tracks() -> None:
    heads = "#multi:\n,B run 1,,A run 1,\nt,x,y,x,y"
    names = read_measured([table(heads, TIMES, B, SLOW, A, SLOW)]).names
    assert sorted(names) == ["A run 1", "B run 1"]


def test_positions_beside_velocities_are_of_the_cart_before_the_colon() -> None:
    heads = "Time (s),A: Position (m),A: Velocity (m/s),B: Position (m),B: Velocity (m/s)"
    still = [0.3] * len(TIMES)
    assert places(table(heads, TIMES, A, still, B, still)) == {"A": A[0], "B": B[0]}


SENSORS = """\
A: x (m)|A: v (m/s)|B: x (m)|B: v (m/s)
A x (m)|A v (m/s)|B x (m)|B v (m/s)
a_x (m)|a_v (m/s)|b_x (m)|b_v (m/s)
Wagen A: s (m)|Wagen A: v (m/s)|Wagen B: s (m)|Wagen B: v (m/s)
Cart A: Position (m)|Cart A: Velocity (m/s)|Cart B: Position (m)|Cart B: Velocity (m/s)"""


@pytest.mark.parametrize(
    ("heads", "own_clocks"),
    [(heads, own) for heads in SENSORS.splitlines() for own in (False, True)[: 1 + (":" in heads)]],
)
def test_letters_and_words_behind_a_cart_are_its_own(heads: str, own_clocks: bool) -> None:
    cells, still = heads.split("|"), [0.3] * len(TIMES)
    clocks = [f"{cells[k].split(':')[0]}: Time (s)" for k in (0, 2)]
    if own_clocks:
        text = table(",".join([clocks[0], *cells[:2], clocks[1], *cells[2:]]),
                     TIMES, A, still, TIMES, B, still)  # fmt: skip
    else:
        text = table(",".join(["Time (s)", *cells]), TIMES, A, still, B, still)
    assert {name.upper(): x for name, x in places(text).items()} == {"A": A[0], "B": B[0]}


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


VELOCITIES = """\
t,v_A,v_B
t,a_A,a_B
t,vA,vB
t,V1,V2
t,Velocity,Velocity 2
t,vel1,vel2
t,B: velocity,A: velocity
t,B: v,A: v
t,加速度A,加速度B
Zeit,Geschwindigkeit A,v B"""


@pytest.mark.parametrize("heads", VELOCITIES.splitlines())
def test_velocities_without_a_unit_are_not_read_as_places(heads: str) -> None:
    with pytest.raises(ReadingError, match="has no unit and is no place"):
        read_measured([table(heads, TIMES, A, B)])


@pytest.mark.parametrize("quantity", ["v_{x}", "v", "a_{x}", "p_{x}", "θ_{v}", "K", "pixel_{x}"])
def test_what_tracker_offers_beside_x_is_not_read_as_places(quantity: str) -> None:
    text = table(f"cart 1,,cart 2,\nt,{quantity},t,{quantity}", TIMES, A, TIMES, B)
    with pytest.raises(ReadingError, match="is no place"):
        read_measured([text])
    assert read_measured([text.replace(quantity, "x")]).names == ("cart 1", "cart 2")


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
