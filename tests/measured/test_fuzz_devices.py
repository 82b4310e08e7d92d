"""Damaged files of each device: a line and a reason, or readings that can be worked with."""

from __future__ import annotations

import io
import math
import zipfile
from random import Random

import pytest

from sim.measured.analysis import analysed
from sim.measured.refusal import ReadingError
from sim.measured.sheet.cells import decoded
from sim.measured.tracks import read_measured
from sim.measured.units import Units
from sim.measured.zipped import texts_of
from tests.measured.camera_systems import frames_of, optitrack, vicon
from tests.measured.devices import Motion, motion_capture, phone, sensor_carts, tracker_project

SHORT = Motion(v=(0.5, -0.1), touch=0.5, until=1.0)
LOG = Motion(v=(0.5, 0.0), touch=1.2, lasts=0.2, until=2.2)
KINDS = {
    "motion capture": motion_capture(SHORT),
    "OptiTrack": optitrack(frames_of(motion_capture(SHORT))),
    "Vicon": vicon(frames_of(motion_capture(SHORT))),
    "sensor carts": sensor_carts(LOG),
    "Tracker's project": tracker_project(SHORT),
    "phone": phone(SHORT, 0),
}
FEW, MANY = 120, 10_000
WORKED_ON = 0.02
"""Share of the readable files that are analysed too."""

SPICE = ["\t", ",", ";", ".", "-", "\u2212", "\n", "\r", "\0", '"', "<", ">", "&", "]]>", "<!--"]
SPICE += ["nan", "inf", "1e999", "9" * 40, "\ufeff", "٣", "0\t0\t0", "MARKER_NAMES\t", "Run 1: "]
SPICE += ["FREQUENCY\t0\n", "FREQUENCY\t-5\n", "Time (s)", "(m)", '<object class="', "</property>"]


def mutated(text: str, random: Random) -> str:
    for _ in range(random.randint(1, 4)):
        at, length = random.randrange(len(text) + 1), random.choice([0, 1, 2, 30, 300, 3000])
        if random.random() < 0.5:
            at = min(at, random.randrange(1, 1200))  # the head holds most of the sense
        kind = random.randrange(5)
        if kind == 0:
            text = text[:at] + random.choice(SPICE) * random.choice([1, 1, 2, 40]) + text[at:]
        elif kind == 1:
            text = text[:at] + text[at + length :]
        elif kind == 2:
            text = text[:at] + text[at : at + length] * 2 + text[at + length :]
        elif kind == 3:
            text = text[:at] + chr(random.randrange(0x250)) + text[at + 1 :]
        else:
            text = text[: max(at, 1)]
    return text


def holds(text: str, random: Random) -> bool:
    """Whether the text was read; asserts that what was read or said makes sense."""
    try:
        found = read_measured([text], Units())
    except ReadingError as error:
        lines = text.count("\n") + text.count("\r") + 1
        assert error.faults
        assert all(1 <= fault.line <= lines and fault.reason for fault in error.faults), error
        return False
    for track in found.tracks:
        assert len(track.t) == len(track.value) == len(track.lines) >= 8
        assert all(a < b for a, b in zip(track.t, track.t[1:], strict=False))
        assert all(map(math.isfinite, (*track.t, *track.value)))
    if found.kind == "length" and random.random() < WORKED_ON:
        told = analysed(found)
        assert (told.refused is None) == bool(told.report["outcome"])
        assert told.refused is None or told.refused.reason
        for one in told.report["known"]:
            assert math.isfinite(one["low"]) and one["low"] < one["high"], one
    return True


@pytest.mark.parametrize("kind", KINDS)
def test_mutated_files_are_read_or_refused_with_a_line_and_a_reason(
    kind: str, request: pytest.FixtureRequest
) -> None:
    count = MANY if request.config.getoption("--fuzz") else FEW
    random = Random(kind)
    read = sum(holds(mutated(KINDS[kind], random), random) for _ in range(count))
    assert read < count  # some are refused
    assert read > 0 or kind == "phone"  # one phone alone is refused, whole or not


def test_mutated_zips_are_read_or_refused(request: pytest.FixtureRequest) -> None:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as pack:
        pack.writestr("Raw Data.csv", KINDS["phone"])
    whole, random = packed.getvalue(), Random(5)
    for _ in range(MANY if request.config.getoption("--fuzz") else FEW):
        content = bytearray(whole)
        for _ in range(random.randint(1, 4)):
            content[random.randrange(4, len(content))] = random.randrange(256)
        try:
            assert texts_of(bytes(content))
        except ReadingError as error:
            assert error.faults[0].reason


def test_bytes_that_are_no_text_name_a_line() -> None:
    with pytest.raises(ReadingError) as caught:
        decoded(KINDS["motion capture"].encode()[:500] + b"\xff\xfe\x00")
    assert caught.value.faults[0].line > 1
