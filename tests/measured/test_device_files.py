"""Files as devices write them: projects, phones, several runs, gaps; and what says too little."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import replace
from random import Random

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.sheet.cells import MOST_BYTES
from sim.measured.tracks import between, read_measured
from sim.measured.units import Units
from sim.measured.zipped import MOST_ZIPPED, texts_of
from tests.measured.device_reports import LOGGED, known, report
from tests.measured.devices import Motion, phone, sensor_carts, tracker_project
from tests.measured.several_runs import below, beside


def test_a_tracker_project_holds_places_times_and_scale() -> None:
    made = Motion(v=(0.5, -0.1), until=2.0, touch=1.0)
    found = read_measured([tracker_project(made)])
    assert found.names == ("A", "B")
    times = list(found.tracks[0].t)
    assert times[0] == pytest.approx(0.0)
    for cart, track in enumerate(found.tracks):
        assert track.value == pytest.approx(made.places(cart, times), abs=3e-3)
    told = report(tracker_project(made))
    assert told["outcome"] == "bounce"
    one = known(told)["mass_ratio"]
    assert one["low"] <= made.ratio <= one["high"]


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (("</object>\n", ""), "damaged"),
        (('"delta_t"', '"other"'), "frame to frame"),
        (("800.0", "1.0"), "no length scale"),
        (('type="double">2.0<', 'type="double">two<'), "no number"),
        (("<object class", "<!DOCTYPE a [<!ENTITY b 'c'>]><object class"), "document type"),
        (("PointMass", "Else"), "no point mass"),
    ],
)
def test_a_project_that_says_too_little_is_refused(change: tuple[str, str], reason: str) -> None:
    text = tracker_project(Motion()).replace(*change)
    with pytest.raises(ReadingError) as caught:
        read_measured([text])
    fault = caught.value.faults[0]
    assert reason in fault.reason
    assert 1 <= fault.line <= text.count("\n") + 1


def test_phones_are_read_along_the_way_they_are_pushed_also_from_a_zip() -> None:
    texts = [phone(Motion(), k, seed=k) for k in (0, 1)]
    found = read_measured(texts)
    assert found.kind == "acceleration"
    assert any("(0.6" in note and "0.8" in note for note in found.notes)
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as pack:
        pack.writestr("meta/device.csv", "property,value\n")
        pack.writestr("Raw Data.csv", texts[0])
    assert texts_of(packed.getvalue()) == [texts[0].removeprefix("\ufeff")]
    with pytest.raises(ReadingError, match="damaged"):
        texts_of(packed.getvalue()[:300])


def test_a_tracker_project_is_read_beside_its_film() -> None:
    packed, project = io.BytesIO(), tracker_project(Motion())
    with zipfile.ZipFile(packed, "w") as pack:
        pack.writestr("run.mp4", Random(1).randbytes(MOST_BYTES + 1))
        pack.writestr("run.trk", project)
    assert texts_of(packed.getvalue()) == [project]
    with pytest.raises(ReadingError, match="larger than 30 MB"):
        texts_of(packed.getvalue() + bytes(MOST_ZIPPED))


def test_a_zip_that_is_packed_in_another_way_is_refused_as_such() -> None:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as pack:
        pack.writestr("run.csv", "t,x\n")
    content = bytearray(packed.getvalue())
    for head, at in ((b"PK\x03\x04", 8), (b"PK\x01\x02", 10)):
        content[content.index(head) + at] = 9  # Deflate64, as Windows packs large files
    with pytest.raises(ReadingError, match="packed in a way that is not read"):
        texts_of(bytes(content))


def test_a_phone_that_tells_g_is_read_in_metres_per_second_squared() -> None:
    texts = [phone(Motion(), k, seed=k) for k in (0, 1)]
    plain = read_measured(texts)
    heads, rows = texts[0].split("\n", 1)
    lines = [line.split(",") for line in rows.splitlines()]
    in_g = [",".join([t, *(f"{float(a) / 9.80665:.12f}" for a in parts)]) for t, *parts in lines]
    texts[0] = "\n".join([heads.replace("m/s^2", "g"), *in_g])
    found = read_measured(texts)
    assert found.tracks[0].value == pytest.approx(plain.tracks[0].value, abs=1e-6)


def test_a_film_beside_a_phone_is_refused_by_what_they_hold() -> None:
    with pytest.raises(ReadingError, match="one file holds positions, another accelerations"):
        read_measured([sensor_carts(LOGGED), phone(Motion(), 0)])


def test_one_phone_is_refused_by_name() -> None:
    with pytest.raises(ReadingError, match="1 phone: two are needed"):
        read_measured([phone(Motion(), 0)])


def test_runs_side_by_side_and_below_each_other_are_told_and_one_is_read() -> None:
    text = sensor_carts(LOGGED).removeprefix("\ufeff")
    lines = text.splitlines()
    below = "\n".join([*lines, *lines[1:]])
    found = read_measured([below])
    assert any("the time starts anew in line" in note for note in found.notes)
    assert len(found.tracks[0].t) == len(lines) - 1
    heads = lines[0].strip('"').split('","')
    both = [",".join(f'"Run {n}: {h}"' for n in (1, 2) for h in heads)]
    both += [f"{line},{line}" for line in lines[1:]]
    found = read_measured(["\n".join(both)])
    assert any("other runs in the file: 2" in note for note in found.notes)
    assert len(found.tracks) == 2


def test_a_lost_cart_leaves_a_gap_that_is_named() -> None:
    lines = sensor_carts(LOGGED).splitlines()
    for k in range(30, 36):
        cells = lines[k].split(",")
        lines[k] = ",".join([cells[0], "", "", "", *cells[4:]])
    found = read_measured(["\n".join(lines)])
    assert any("6 rows without a reading" in note for note in found.notes)
    assert any("no reading from" in note for note in found.notes)


@pytest.mark.parametrize("together", [beside, below], ids=["side by side", "below each other"])
def test_of_several_runs_the_one_that_is_asked_for_is_read(
    together: Callable[[Sequence[str]], str],
) -> None:
    texts = [sensor_carts(Motion(), seed=k) for k in (1, 2, 3)]
    text = together(texts)
    for k, one in enumerate(texts, 1):
        found, alone = read_measured([text], Units(run=str(k))), read_measured([one])
        assert found.runs == ("1", "2", "3")
        assert [track.t for track in found.tracks] == [track.t for track in alone.tracks]
        assert [track.value for track in found.tracks] == [t.value for t in alone.tracks]
    assert read_measured([text]).tracks[0].value == read_measured([texts[0]]).tracks[0].value
    with pytest.raises(ReadingError, match="there is no run 4: this file has 3"):
        read_measured([text], Units(run="4"))
    assert read_measured([texts[0]]).runs == ()


@pytest.mark.parametrize("together", [beside, below])
def test_a_first_run_that_was_stopped_at_once_is_passed_over(
    together: Callable[[Sequence[str]], str],
) -> None:
    whole = sensor_carts(Motion(), seed=2)
    heads, *rows = whole.splitlines()
    empty = "," * heads.count(",") if together is beside else ""
    stopped = [heads, *rows[:5], *(empty for _ in rows[5:] if empty)]
    found = read_measured([together(["\n".join(stopped), whole])])
    alone = read_measured([whole])
    assert [track.value for track in found.tracks] == [track.value for track in alone.tracks]


def test_a_span_of_time_changes_nothing_else_that_was_read() -> None:
    text = below([sensor_carts(Motion(), seed=k) for k in (1, 2)])
    whole = read_measured([text], Units(run="2"))
    span = between(whole, 0.1, None)
    assert whole.runs == ("1", "2")
    assert span.tracks[0].t[0] >= 0.1 > whole.tracks[0].t[0]
    assert replace(span, tracks=whole.tracks) == whole
