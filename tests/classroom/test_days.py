"""The day on a slip is the day of the lesson, wherever on Earth that is."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator

import pytest

from sim.classroom.handouts.slip_page import day_of

if not hasattr(time, "tzset"):
    pytest.skip("Windows sets the zone of a computer, not of a program", allow_module_level=True)


@pytest.fixture
def live_in(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str], None]]:
    def moved(zone: str) -> None:
        monkeypatch.setenv("TZ", zone)
        time.tzset()

    yield moved
    monkeypatch.undo()
    time.tzset()


@pytest.mark.parametrize(
    ("zone", "saved", "day"),
    [
        ("<+08>-8", "2026-09-01T23:30:00.000Z", "2026-09-02"),  # Singapore, 7:30
        ("<-06>6", "2026-09-02T02:00:00.000Z", "2026-09-01"),  # Costa Rica, 20:00
        ("UTC0", "2026-09-01T23:30:00.000Z", "2026-09-01"),
        ("<+08>-8", "2026-09-01T23:30:00Z", "2026-09-02"),
    ],
)
def test_a_slip_shows_the_day_that_it_was_here(
    zone: str, saved: str, day: str, live_in: Callable[[str], None]
) -> None:
    live_in(zone)
    assert day_of(saved) == day


@pytest.mark.parametrize(
    ("saved", "day"),
    [("", ""), ("soon", "soon"), ("0001-01-01T00:00:00Z", "0001-01-01"),
     ("9999-12-31T23:59:59Z", "9999-12-31")],
)  # fmt: skip
def test_what_is_no_moment_of_any_calendar_is_shown_as_it_stands(
    saved: str, day: str, live_in: Callable[[str], None]
) -> None:
    live_in("<+08>-8" if saved > "1" else "<-06>6")
    assert day_of(saved) == day
