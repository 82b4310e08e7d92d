"""One isolated contact, law by law, against integration of the force and against tables."""

from __future__ import annotations

import itertools
import math

import pytest

from sim.laws.bumper.law import Bumper
from sim.laws.paper.law import Paper
from sim.laws.push_only.law import PushOnly
from sim.laws.push_only_uncorrected.law import PushOnlyUncorrected
from tests.reference import force_laws

LAWS = {
    "bumper": Bumper,
    "paper": Paper,
    "push-only": PushOnly,
    "push-only-uncorrected": PushOnlyUncorrected,
}
PAIRS = [(500.0, 2 / 3, 1.5), (20.0, 0.05, 0.01), (5e4, 3.0, 4.0)]  # k N/m, mu kg, u m/s

INTEGRATION = 1e-9
"""Relative. DOP853 at 1e-12, a few hundred steps, event located to 4 eps of the step."""

ON_A_GRID = 1e-6
"""Relative. The oracle reads the greatest force off 4000 points of a smooth maximum."""

ROUNDING = 8 * 2.0**-52
"""Relative. A handful of roundings in exp, sin and products."""


@pytest.mark.parametrize("e", [1.0, 0.95, 0.8, 0.5, 0.2, 0.05])
@pytest.mark.parametrize(("k", "mu", "u"), PAIRS)
@pytest.mark.parametrize("law", LAWS)
def test_figures_agree_with_integration_of_the_force(law, k, mu, u, e):
    figures = LAWS[law](k, e).figures(mu)
    expected = force_laws.integrate(law, e, k, mu, u)
    assert figures.duration == pytest.approx(expected.duration, rel=INTEGRATION)
    assert figures.e * u == pytest.approx(expected.separation_speed, rel=INTEGRATION)
    assert figures.out_overlap * u == pytest.approx(expected.overlap_left, abs=INTEGRATION * u)
    assert figures.peak_force * u == pytest.approx(expected.greatest_force, rel=ON_A_GRID)
    assert mu * (1 + figures.e) * u == pytest.approx(expected.impulse, rel=INTEGRATION)


@pytest.mark.parametrize("e", [1.0, 0.999, 0.8, 0.3, 0.1, 1e-3, 1e-6])
@pytest.mark.parametrize("law", LAWS)
def test_the_closed_form_ends_where_the_figures_say(law, e):
    k, mu, u = 500.0, 2 / 3, 1.5
    figures = LAWS[law](k, e).figures(mu)
    stretches = LAWS[law](k, e).stretches(mu, 0.0, u, 0.0)
    assert math.fsum(s.duration for s in stretches) == pytest.approx(figures.duration, rel=1e-13)
    overlap, rate = stretches[-1].end()
    assert -rate == pytest.approx(figures.e * u, abs=ROUNDING * u)
    assert overlap == pytest.approx(
        figures.out_overlap * u, abs=ROUNDING * u * figures.peak_overlap + 1e-17
    )


@pytest.mark.parametrize("e", [0.9, 0.5, 0.05])
@pytest.mark.parametrize("law", LAWS)
def test_each_stretch_takes_over_where_the_last_one_ends(law, e):
    stretches = LAWS[law](300.0, e).stretches(0.4, 0.0, 0.7, 0.0)
    for before, after in itertools.pairwise(stretches):
        d, v = before.end()
        assert after.d0 == pytest.approx(d, rel=1e-14)
        assert after.v0 == pytest.approx(v, abs=1e-14)


@pytest.mark.parametrize("e", [0.9, 0.5, 0.1])
@pytest.mark.parametrize("law", ["bumper", "push-only", "push-only-uncorrected"])
def test_these_laws_never_pull(law, e):
    for swing in LAWS[law](500.0, e).stretches(0.5, 0.0, 1.0, 0.0):
        for k in range(101):
            assert -swing.at(swing.start + swing.duration * k / 100)[2] >= -1e-12


@pytest.mark.parametrize("e", [1.0, 0.8, 0.3, 0.0])
def test_the_bumper_starts_from_zero_and_peaks_at_u_sqrt_k_mu(e):
    figures = Bumper(500.0, e).figures(0.5)
    assert figures.first_force == 0.0
    assert figures.peak_force == pytest.approx(math.sqrt(500.0 * 0.5), rel=ROUNDING)


# Damping ratios and restitutions of the three readings of equation (3), six figures.
TABLE = [
    (0.99, 0.003199, 0.99002, 0.003206),
    (0.9, 0.033518, 0.90203, 0.034265),
    (0.8, 0.070850, 0.80810, 0.074355),
    (0.5, 0.215454, 0.55028, 0.255276),
    (0.2, 0.455950, 0.32486, 0.731247),
    (0.1, 0.591155, 0.25273, 1.243188),
    (0.01, 0.826085, 0.17288, 4.806942),
]


@pytest.mark.parametrize(("e", "zeta_printed", "e_clipped", "zeta_corrected"), TABLE)
def test_three_readings_of_equation_3(e, zeta_printed, e_clipped, zeta_corrected):
    assert Paper(500.0, e).damping.zeta == pytest.approx(zeta_printed, abs=5e-7)
    assert PushOnlyUncorrected(500.0, e).delivered == pytest.approx(e_clipped, abs=6e-6)
    assert PushOnly(500.0, e).damping.zeta == pytest.approx(zeta_corrected, abs=5e-7)


@pytest.mark.parametrize("exponent", range(0, 13))
def test_corrected_damping_delivers_what_was_asked_down_to_1e_minus_12(exponent):
    e = 10.0**-exponent
    d = PushOnly(1.0, e).damping
    delivered = math.exp(-2.0 * d.zeta / d.sinc)
    assert delivered == pytest.approx(e, rel=5e-14)  # exp of 28 amplifies an ulp about 30 times


def test_without_restitution_the_paper_law_never_separates():
    law = Paper(500.0, 0.0)
    assert law.figures(0.5).duration == math.inf
    (swing,) = law.stretches(0.5, 0.0, 1.0, 0.0)
    w = math.sqrt(1000.0)
    assert swing.at(0.1)[0] == pytest.approx(0.1 * math.exp(-w * 0.1), rel=1e-13)
    assert swing.at(1e4)[0] == 0.0


@pytest.mark.parametrize("e", [1.0, 0.8, 0.4])
def test_a_compressed_spring_lets_go_with_the_known_speed(e):
    k, mu, d0 = 500.0, 0.6, 0.02
    (swing,) = Paper(k, e).stretches(mu, d0, 0.0, 0.0)
    phi = math.atan2(math.pi, -math.log(e))
    expected = d0 * math.sqrt(k / mu) * math.exp(-math.cos(phi) * (math.pi - phi) / math.sin(phi))
    assert -swing.end()[1] == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("e", [0.9, 0.6, 0.2])
def test_a_bumper_pressed_again_before_it_is_clear_climbs_the_steep_line_first(e):
    law, mu, dm = Bumper(500.0, e), 0.5, 0.01
    rest = law.resting_overlap(dm)
    gentle = law.stretches(mu, rest, 1e-3, dm)
    assert len(gentle) == 1  # turns on the steep line: elastic
    assert -gentle[0].end()[1] == pytest.approx(1e-3, rel=1e-12)
    hard = law.stretches(mu, rest, 5.0, dm)
    assert len(hard) == 3
    energy = 0.5 * mu * 25.0 + law.stored(rest, 5.0, dm)
    deepest = hard[-1].d0
    pressed = 0.5 * law.stiffness * (deepest**2 - dm**2) + law.stored(dm, 0.0, dm)
    assert pressed == pytest.approx(energy, rel=1e-12)
