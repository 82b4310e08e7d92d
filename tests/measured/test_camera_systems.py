"""Whichever cameras follow the markers: the same motion reads the same from what each exports."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from tests.measured.camera_systems import RATE, Frames, frames_of, optitrack, vicon
from tests.measured.devices import Motion, motion_capture

WRITTEN = 1e-6  # m: the last digit of the coarser file

WRITERS: dict[str, tuple[Callable[[Frames], str], list[str]]] = {
    "optitrack, markers": (optitrack, ["cart 1", "cart 2"]),
    "optitrack, bodies": (lambda frames: optitrack(frames, bodies=True), ["cart 1", "cart 2"]),
    "vicon": (vicon, ["A", "B"]),
}


@pytest.mark.parametrize("name", WRITERS)
def test_one_motion_reads_the_same_from_every_system(name: str) -> None:
    write, names = WRITERS[name]
    text = motion_capture(Motion(), hidden=(40, 41, 42))
    known = read_measured([text])
    found = read_measured([write(frames_of(text))])
    assert [track.name for track in found.tracks] == names
    assert any(f"{RATE} frames per second" in note for note in found.notes)
    assert any("3 of 750 frames hidden" in note for note in found.notes)
    for track, same in zip(found.tracks, known.tracks, strict=True):
        assert track.t == pytest.approx(same.t, abs=1e-9)
        assert track.value == pytest.approx(same.value, abs=WRITTEN)


def test_a_turn_of_a_body_is_no_place() -> None:
    frames = frames_of(motion_capture(Motion()))
    text = optitrack(frames, bodies=True).replace("Position", "Rotation")
    with pytest.raises(ReadingError, match="no column holds positions"):
        read_measured([text])


@pytest.mark.parametrize(
    ("write", "old", "new", "why"),
    [
        (optitrack, "Meters", "Furlongs", "no unit of lengths"),
        (optitrack, "0.004000", "soon", "not a number"),
        (vicon, "250\n", "fast\n", "frames per second"),
        (vicon, ",,mm,mm,mm", ",,ft,mm,mm", "unit of lengths"),
        (vicon, "carts:A,,,carts:B", ",,,", "no marker is named"),
    ],
)
def test_what_is_not_as_it_should_be_is_refused_with_its_line(
    write: Callable[[Frames], str], old: str, new: str, why: str
) -> None:
    text = write(frames_of(motion_capture(Motion())))
    assert old in text
    with pytest.raises(ReadingError, match=why) as refused:
        read_measured([text.replace(old, new, 1)])
    assert refused.value.faults[0].line > 0


def test_a_file_that_ends_after_its_heads_is_refused() -> None:
    for text in (optitrack([]), vicon([])):
        with pytest.raises(ReadingError, match="frame"):
            read_measured([text])


def test_frames_of_a_network_that_follows_animals_are_no_seconds() -> None:
    """DeepLabCut numbers its frames under `coords`; read as seconds, carts crept."""
    frames = frames_of(motion_capture(Motion()))
    heads = ["scorer" + ",net" * 6, "bodyparts" + ",A" * 3 + ",B" * 3,
             "coords" + ",x,y,likelihood" * 2]  # fmt: skip
    rows = [f"{k},{f[0]},{f[1]},0.99,{f[3]},{f[4]},0.98" for k, f in enumerate(frames)]
    with pytest.raises(ReadingError, match="counts frames"):
        read_measured(["\n".join([*heads, *rows])])


def test_an_object_in_each_line_is_a_row() -> None:
    times = [k / 50 for k in range(150)]
    a, b = (Motion().places(cart, times) for cart in (0, 1))
    rows = [
        f'{{"t": {t:.2f}, "x1": {x:.5f}, "x2": {y:.5f}}}'
        for t, x, y in zip(times, a, b, strict=True)
    ]
    found = read_measured(["\n".join(rows)])
    assert found.tracks[1].value == pytest.approx(b, abs=1e-5)
    assert found.tracks[0].t == pytest.approx(times, abs=1e-9)
