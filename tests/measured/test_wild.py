"""A few wild readings move neither the fit nor its interval; what is sharp and real stays."""

from __future__ import annotations

from dataclasses import replace
from random import Random

import pytest

from sim.measured.analysis import Wanted, analysed
from sim.measured.events.story import story_of
from sim.measured.events.wild import of_aside, wild_of, without_wild
from sim.measured.model.fit import fit
from sim.measured.track import Track
from sim.measured.tracks import Measured, read_measured
from tests.measured.devices import Motion, motion_capture, sensor_carts
from tests.measured.makers import NOISE, film, truth

EXPLOSION = Motion(v=(0.0, 0.0), apart=0.6, ratio=1.5, touch=0.8, until=1.8, brake=0.0)
MOVED = 0.25
"""Standard deviations by which a reading among hundreds may move what is fitted."""


def with_wild(measured: Measured, off: dict[int, float], cart: int = 0) -> Measured:
    """Readings `off` m away from where they were, by their place in the track."""
    track = measured.tracks[cart]
    value = tuple(x + off.get(k, 0.0) for k, x in enumerate(track.value))
    tracks = [replace(track, value=value) if k == cart else one
              for k, one in enumerate(measured.tracks)]  # fmt: skip
    return replace(measured, tracks=(tracks[0], tracks[1]))


@pytest.mark.parametrize("off", [{100: 0.02}, {100: 0.3, 101: -0.2, 400: 4.0}, {0: 0.1, 749: -0.1},
                                 {200: 1.0, 201: 1.0, 202: 1.0}])  # fmt: skip
def test_wild_readings_are_set_aside_and_told(off: dict[int, float]) -> None:
    measured = read_measured([motion_capture(Motion())])
    calm, aside = without_wild(with_wild(measured, off))
    assert [round(one.t * 250) for one in aside] == sorted(off)
    assert len(calm.tracks[0].t) == len(measured.tracks[0].t) - len(off)
    (said,) = of_aside(aside, measured.names)
    assert ("1 reading of" if len(off) == 1 else f"{len(off)} readings of") in said


def test_of_white_noise_nothing_is_set_aside() -> None:
    random = Random(5)
    for _ in range(20):
        x = tuple(0.3 * k / 120 + random.gauss(0.0, NOISE) for k in range(300))
        assert (
            wild_of(Track("A", tuple(k / 120 for k in range(300)), x, tuple(range(300)))) == set()
        )


@pytest.mark.parametrize("made", [EXPLOSION, Motion(v=(0.5, 0.0), lasts=0.05, until=2.5)])
def test_a_contact_shorter_than_two_readings_is_not_wild(made: Motion) -> None:
    measured = read_measured([sensor_carts(made)])
    near = [one for one in without_wild(measured)[1] if abs(one.t - made.touch) < 0.2]
    assert near == []


def test_one_wild_reading_a_second_leaves_outcome_and_interval_as_they_were() -> None:
    made, random = Motion(), Random(3)
    plain = read_measured([motion_capture(made)])
    off = {random.randrange(250 * s, 250 * s + 250): random.uniform(-0.3, 0.3) for s in range(3)}
    before, after = (analysed(one, Wanted(every=False)).report
                     for one in (plain, with_wild(plain, off, cart=1)))  # fmt: skip
    assert after["outcome"] == before["outcome"] == "bounce"
    assert len(after["aside"]) == 3
    first, second = ({one["key"]: one for one in told["known"]}["mass_ratio"]
                     for told in (before, after))  # fmt: skip
    assert second["value"] == pytest.approx(first["value"], abs=MOVED * first["sd"])
    assert second["sd"] == pytest.approx(first["sd"], rel=0.1)


@pytest.mark.parametrize("where", [20, 40, 60])
def test_a_reading_of_six_deviations_counts_less_and_moves_nothing(where: int) -> None:
    plain = film(truth(contact=0.12, v=(0.8, -0.2)), rate=120)
    without = fit(plain)
    bent = fit(with_wild(plain, {where: 6.0 * NOISE - without.residuals[0][where]}))
    assert (without.heavy, bent.heavy) == (0, 1)
    for name, first, second in zip(without.unknowns, without.values, bent.values, strict=True):
        assert abs(second - first) < 4.0 * MOVED * without.sd(name), name
    assert bent.noise == pytest.approx(without.noise, rel=0.05)


def test_two_hands_that_push_at_one_time_are_no_contact() -> None:
    """Both carts are set going together, far apart; they touch later."""
    measured = read_measured([motion_capture(Motion(v=(0.2, -0.2), until=2.5))])
    tracks = []
    for track in measured.tracks:
        v = (track.value[25] - track.value[0]) / 0.1
        still = [track.value[0] - 0.15 * v] * 250
        going = [still[0] + v * 0.3 * (k / 75) ** 2 / 2 for k in range(1, 76)]
        t = tuple(k / 250 for k in range(len(track.t) + 325))
        x = (*still, *going, *track.value)
        tracks.append(Track(track.name, t, x, tuple(range(len(t)))))
    story = story_of(replace(measured, tracks=(tracks[0], tracks[1])))
    assert story.contact and story.contact.middle == pytest.approx(1.3 + 1.5, abs=0.05)
    assert story.outcome == "bounce"


def test_positions_of_two_sensors_under_plain_heads_are_two_frames() -> None:
    """A cart that its sensor lost stands still: no model of one frame makes a bounce of it."""
    text = sensor_carts(Motion(v=(0.5, 0.0), e=0.0, ratio=1.6, touch=1.3, lasts=0.2), lost=0.66)
    rows = [line.split(",") for line in text.splitlines()]
    plain = "t (s);x_A (m);x_B (m)\n" + "\n".join(f"{r[0]};{r[1]};{r[4]}" for r in rows[1:])
    found = analysed(read_measured([plain]))
    assert found.report["outcome"] is None
    assert found.report["refused"]["code"] in ("lost-after", "perhaps-lost", "not-in-step")


def test_a_ratio_counts_what_friction_takes_in_the_contact() -> None:
    told = analysed(film(truth(), rate=120), Wanted(every=False)).report
    one = {row["key"]: row for row in told["known"]}["mass_ratio"]
    low, high = one["alone"]
    assert one["low"] < low < one["value"] < high < one["high"]
    assert "the readings alone" in one["text"]
    assert any("the cart rubs" in said for said in told["sentences"])
