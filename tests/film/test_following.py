"""Marks are followed through films whose motion is known, to a small part of a pixel."""

from __future__ import annotations

import io

import numpy as np
import pytest
from numpy.typing import NDArray

from sim.measured.tracks import read_measured
from tests.film.collision import uneven
from tests.film.following import follow, missed
from tests.film.maker import Stage, encoded, frames
from tests.web.scene.given.widget_site import in_node

PROMISED = 0.2  # pixels: what the page says of marks in a film without noise
CLEAN = 0.03  # pixels: what it does
NOISY = 0.1  # pixels, for 12 of 255 in every pixel
SQUEEZED = 0.4  # pixels, after a phone's compression: its blocks are no noise that averages out
SAME = 0.1  # pixels between the middles that two clicks on one mark find

Motion = list[NDArray[np.float64]]


def bump(times: NDArray[np.float64]) -> Motion:
    """A comes, turns round between two frames; B leaves."""
    after = np.maximum(0.0, times - 0.8)
    a = 0.35 + 0.6 * np.minimum(times, 0.8) - 0.15 * after
    return [a, 1.1 + 0.4 * after]


@pytest.mark.parametrize(
    ("stage", "most"),
    [
        (Stage(), CLEAN),
        (Stage(radius=4), CLEAN),
        (Stage(radius=18), CLEAN),
        (Stage(tilt=0.06), CLEAN),
        (Stage(noise=12), NOISY),
        (Stage(noise=6, blur=0.015), NOISY),
    ],
    ids=["plain", "small", "large", "tilted", "noise", "blur"],
)
def test_marks_are_found_to_a_small_part_of_a_pixel(stage: Stage, most: float) -> None:
    assert most <= PROMISED
    times = uneven(1.4, 30)
    motion = bump(times)
    clicks = [stage.place(float(x[0])) for x in motion]
    found = follow(stage, frames(stage, times, motion), times, clicks)
    assert [found.lost(k) for k in (0, 1)] == [[], []]
    assert max(missed(found, stage, motion)) <= most


def test_compression_costs_less_than_half_a_pixel() -> None:
    import av

    stage, times = Stage(noise=3), uneven(1.4, 30)
    motion = bump(times)
    content = encoded(
        frames(stage, times, motion), times, stage,
        codec="libx264", kind="mp4", options={"preset": "medium", "crf": "28"},
    )  # fmt: skip
    with av.open(io.BytesIO(content)) as film:
        decoded = [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]
    assert len(decoded) == len(times)
    found = follow(stage, decoded, times, [stage.place(float(x[0])) for x in motion])
    assert max(missed(found, stage, motion)) <= SQUEEZED


def test_a_click_anywhere_on_a_mark_finds_its_middle() -> None:
    stage = Stage(noise=3)
    x, y = stage.place(0.7)
    beside = [(0, 0), (5, 0), (0, -6), (-4, 4), (3, 5)]
    pictures = list(frames(stage, [0.0, 0.1], [np.array([0.7, 0.7]), np.array([1.5, 1.5])]))
    found = follow(stage, pictures, [0.0, 0.1], [(x + dx, y + dy) for dx, dy in beside])
    for places in found.places:
        assert np.abs(places[0] - (x, y)).max() <= SAME


def test_where_nothing_stands_out_no_mark_is_taken() -> None:
    stage = Stage(noise=3)
    pictures = list(frames(stage, [0.0], [np.array([0.7]), np.array([1.5])]))
    found = follow(stage, pictures, [0.0], [(320, 20), (500, 40), stage.place(0.7)])
    assert found.known == [False, False, True]


def test_a_hidden_mark_is_lost_in_those_frames_only_and_found_again() -> None:
    stage, times = Stage(noise=3), uneven(1.4, 30)
    motion = bump(times)
    hidden = range(12, 17)
    pictures = list(frames(stage, times, motion))
    for k in hidden:  # a hand in front of cart A
        x, _ = stage.place(float(motion[0][k]))
        pictures[k][60:150, int(x) - 40 : int(x) + 40] = (196, 160, 140)
    found = follow(stage, pictures, times, [stage.place(float(x[0])) for x in motion])
    assert found.lost(0) == list(hidden)
    assert found.lost(1) == []
    assert max(missed(found, stage, motion)) <= NOISY


def test_a_mark_that_leaves_the_picture_is_lost_and_no_other_place_is_taken_for_it() -> None:
    stage, times = Stage(noise=3), uneven(1.0, 30)
    motion = [1.2 + 1.2 * times, np.full_like(times, 0.5)]
    pictures = frames(stage, times, motion)
    found = follow(stage, pictures, times, [stage.place(float(x[0])) for x in motion])
    gone = [k for k, x in enumerate(motion[0]) if stage.place(float(x))[0] > stage.width + 12]
    assert set(gone) <= set(found.lost(0))
    assert found.lost(1) == []


def test_two_marks_of_one_colour_keep_their_names() -> None:
    class Alike(Stage):
        colours = (Stage.colours[0],) * 2

    stage, times = Alike(), uneven(1.4, 30)
    motion = bump(times)
    pictures = frames(stage, times, motion)
    found = follow(stage, pictures, times, [stage.place(float(x[0])) for x in motion])
    assert max(missed(found, stage, motion)) <= CLEAN


@pytest.mark.parametrize("tilt", [0.0, 0.08, -0.3])
def test_the_readings_are_metres_along_the_track_and_seconds_of_the_film(tilt: float) -> None:
    stage, times = Stage(tilt=tilt, height=400), uneven(1.4, 30)
    motion = bump(times)
    pictures = list(frames(stage, times, motion))
    pictures[20][:] = 128  # nothing in it: an empty cell
    clicks = [stage.place(float(x[0])) for x in motion]
    found = follow(stage, pictures, times, clicks, slower=4)
    assert found.text.startswith("# a film\nt (s);x_A (m);x_B (m)\n")
    read = read_measured([found.text])
    assert read.names == ("A", "B")
    seen = [k for k in range(len(times)) if k != 20]
    for track, x in zip(read.tracks, motion, strict=True):
        assert list(track.t) == pytest.approx(times[seen] / 4, abs=1e-6)
        apart = np.array(track.value) - x[seen]
        assert np.ptp(apart) <= 2 * PROMISED / stage.scale  # m; where 0 lies is free
    between = [track.value[0] for track in read.tracks]
    assert between[1] - between[0] == pytest.approx(motion[1][0] - motion[0][0], abs=1e-3)


def test_a_film_on_its_side_is_read_downwards_however_its_marks_scatter() -> None:
    """Upright but for a degree, one way or the other; one that rises to the right stays so."""
    leans = ((0.0, 10), (0.1, 10), (-0.1, 10), (9, 10), (10, -9))  # pixels from frame to frame
    film = [[{"t": k, "marks": [{"x": x * k, "y": y * k}] * 2} for k in range(9)] for x, y in leans]
    axes = in_node(
        'const { direction } = await import(source + "/film/along.js"); give(data.map(direction));',
        film,
    )
    assert [axis["y"] > 0.5 for axis in axes] == [True, True, True, True, False]
    assert axes[-1]["x"] > 0.5


ROWS = [
    {"t": 0.0, "marks": [{"x": 10, "y": 5}, None]},
    {"t": 0.1, "marks": [None, None]},
    {"t": 0.4, "marks": [{"x": 50, "y": 9}, {"x": 7, "y": 7}]},
]


def test_lost_places_are_gone_through_once_set_or_left_out() -> None:
    found = in_node(
        """const { Mending } = await import(source + "/film/mending.js");
        const mending = new Mending(data);
        const first = mending.counts(["A", "B"]);
        const expected = [0, 1].map((mark) => mending.expected({ row: 1, mark }));
        const order = [];
        for (let at = { row: 0, mark: 0 }; order.length < 9; ) {
          at = mending.after(at);
          if (!at) break;
          order.push([at.row, at.mark]);
          if (at.mark) mending.leave(at);
          else mending.set(at, { x: 20, y: 6 });
        }
        give({ first, expected, order, rows: mending.rows,
          at: [-1, 0.05, 0.1, 0.39, 9].map((t) => mending.at(t)) });""",
        ROWS,
    )
    assert [one["count"] for one in found["first"]] == [1, 2]
    assert found["expected"][0] == pytest.approx({"x": 20, "y": 6})  # a quarter of the way
    assert found["expected"][1] == {"x": 7, "y": 7}
    assert found["order"] == [[0, 1], [1, 0], [1, 1]]
    assert found["rows"][1]["marks"] == [{"x": 20, "y": 6}, None]
    assert found["at"] == [0, 0, 1, 1, 2]
