"""A clock that begins anew while the carts roll is counted on; a run that begins anew is a run."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from sim.measured.refusal import ReadingError
from sim.measured.tracks import read_measured
from tests.measured.device_reports import LOGGED
from tests.measured.devices import phone, sensor_carts
from tests.measured.several_runs import below
from tests.measured.written_films import A, B, T

HEADS = "{},x_A (m),x_B (m)"
LOG = sensor_carts(LOGGED).removeprefix("\ufeff").replace('"', "").splitlines()
AWAY = 1.0  # s: the clock begins anew so long after the first reading


def minutes(t: float) -> str:
    past = (3600.0 - AWAY + t) % 3600.0
    return f"{int(past // 60):02d}:{past % 60:09.6f}"


def of_the_day(t: float) -> str:
    past = (86_400.0 - AWAY + t) % 86_400.0
    return f"{int(past // 3600):02d}:{int(past // 60) % 60:02d}:{past % 60:09.6f}"


def seconds_of_the_day(t: float) -> str:
    return f"{(86_400.0 - AWAY + t) % 86_400.0:.6f}"


def in_32_bits(unit: float) -> Callable[[float], str]:
    return lambda t: f"{round(2**32 - AWAY / unit + t / unit) % 2**32}"


CLOCKS = {
    "minutes": ("Time", minutes, 1e-5),
    "times of day": ("Time", of_the_day, 1e-5),
    "seconds of the day": ("t (s)", seconds_of_the_day, 1e-5),
    "millis": ("millis", in_32_bits(1e-3), 1.1e-3),
    "micros": ("micros", in_32_bits(1e-6), 2e-6),
    "a counter": ("t (ms)", in_32_bits(1e-3), 1.1e-3),
}


@pytest.mark.parametrize(("name", "clock", "sure"), CLOCKS.values(), ids=CLOCKS)
def test_a_clock_that_begins_anew_in_a_film_is_counted_on(
    name: str, clock: Callable[[float], str], sure: float
) -> None:
    lines = [f"{clock(t - T[0])},{a},{b}" for t, a, b in zip(T, A, B, strict=True)]
    found = read_measured(["\n".join([HEADS.format(name), *lines])])
    for track in found.tracks:
        assert [t - track.t[0] for t in track.t] == pytest.approx([t - T[0] for t in T], abs=sure)
        assert len(track.t) == len(T)
    assert any("the clock begins anew in line" in note for note in found.notes)


@pytest.mark.parametrize(("name", "clock", "sure"), CLOCKS.values(), ids=CLOCKS)
def test_a_clock_that_begins_anew_in_a_log_loses_no_row(
    name: str, clock: Callable[[float], str], sure: float
) -> None:
    rows = [line.split(",", 1) for line in LOG]
    wanted = [float(t) for t, _ in rows[1:]]
    lines = [f"{name},{rows[0][1]}", *(f"{clock(float(t))},{rest}" for t, rest in rows[1:])]
    found = read_measured(["\n".join(lines)])
    t = found.tracks[0].t
    assert [one - t[0] for one in t] == pytest.approx([s - wanted[0] for s in wanted], abs=sure)
    assert any("the clock begins anew in line" in note for note in found.notes)
    assert not any("readings of one run are taken" in note for note in found.notes)


def test_a_phone_whose_clock_begins_anew_loses_no_row() -> None:
    texts = []
    for cart in (0, 1):
        heads, *lines = phone(LOGGED, cart).splitlines()
        rows = (line.split(",", 1) for line in lines)
        texts.append("\n".join([heads, *(f"{seconds_of_the_day(float(t))},{a}" for t, a in rows)]))
    found = read_measured(texts)
    assert [len(track.t) for track in found.tracks] == [text.count("\n") for text in texts]


def test_a_run_that_begins_anew_is_a_run() -> None:
    text = below(["\n".join(LOG), "\n".join(LOG)])
    found = read_measured([text])
    assert len(found.tracks[0].t) == len(LOG) - 1
    assert not any("counted on" in note for note in found.notes)


@pytest.mark.parametrize("back", [1800.0, 3500.0])
def test_a_time_that_goes_back_by_another_span_is_refused_as_before(back: float) -> None:
    lines = [f"{4000.0 + t - (back if t > T[0] + AWAY else 0.0)},{a},{b}"
             for t, a, b in zip(T, A, B, strict=True)]  # fmt: skip
    with pytest.raises(ReadingError, match="the time goes back"):
        read_measured(["\n".join([HEADS.format("t (s)"), *lines])])
