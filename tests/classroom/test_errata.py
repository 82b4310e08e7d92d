"""One test for each slip of the paper: the literal formula lives here and nowhere else."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import combinations_with_replacement
from statistics import stdev

import pytest

from sim.classroom.paper import largest_deviation, whole_total
from sim.classroom.statistics.tails import normal_inside, normal_two_sided
from sim.dynamics.loop.run import run
from sim.scene import SceneError, read_scene
from tests.classroom.given.paper_tables import TABLE_2, TABLE_3, text

K, M1, M2, LENGTH = 500.0, 0.5, 1.0, 0.2


def printed(x: float, v: float, e: float, log: Callable[[float], float] = math.log) -> float:
    """Equation (3) as it stands in the paper; x = x₁ − x₂, v = v₁ − v₂."""
    zeta = math.sqrt(log(e) ** 2 / (math.pi**2 + log(e) ** 2))
    return -2 * zeta * math.sqrt(K * M1 * M2 / (M1 + M2)) * v + K * x


def delivered(e: float, log: Callable[[float], float]) -> float:
    """What a linear spring and damper with the printed ζ return: exp(−πζ/√(1 − ζ²))."""
    zeta = math.sqrt(log(e) ** 2 / (math.pi**2 + log(e) ** 2))
    return math.exp(-math.pi * zeta / math.sqrt(1 - zeta**2))


def test_the_printed_spring_pulls_where_the_damper_is_right() -> None:
    # Cart 1 comes from the left: what stops it points to the left, and so does the damping.
    assert printed(0.0, 0.6, 0.8) < 0
    overlap = 0.01  # put in the place of x₁ − x₂, it pulls cart 1 further in
    assert printed(overlap, 0.0, 0.8) > 0


def test_the_distance_of_centres_is_not_the_overlap() -> None:
    assert printed(-LENGTH, 0.0, 0.8) == pytest.approx(-100)  # at first touch, nothing squeezed


def test_without_a_contact_condition_carts_push_each_other_from_afar() -> None:
    assert printed(-1.0, 0.0, 1.0) == -500


def test_the_logarithm_is_the_natural_one() -> None:
    assert delivered(0.8, math.log) == pytest.approx(0.8, rel=1e-12)
    assert round(delivered(0.8, math.log10), 4) == 0.9076


def test_a_restitution_of_zero_has_no_logarithm() -> None:
    with pytest.raises(ValueError, match=r"math domain|positive"):
        printed(0.0, 0.6, 0.0)
    assert run(read_scene(scene(restitution=0))).outcome.kind == "reached-end"


def test_a_restitution_above_one_passes_silently_in_the_printed_formula() -> None:
    assert printed(0.0, 0.6, 1.25) == pytest.approx(printed(0.0, 0.6, 0.8), rel=1e-12)
    with pytest.raises(SceneError):
        read_scene(scene(restitution=1.25))


def scene(restitution: float) -> dict[str, object]:
    """Two carts that meet, with the mended law."""
    return {
        "carts": {"A": {"mass": M1, "position": 0.4, "velocity": 0.6},
                  "B": {"mass": M2, "position": 1.2}},
        "contact": {"law": "paper", "restitution": restitution, "stiffness": K},
        "until": 3,
    }  # fmt: skip


def test_the_mended_law_delivers_what_is_asked_for() -> None:
    a, b = run(read_scene(scene(restitution=0.8))).v
    assert b - a == pytest.approx(0.8 * 0.6, rel=1e-12)


@pytest.mark.parametrize(("law", "p"), [("first", 0.026), ("third", 0.449)])
def test_the_printed_p_is_one_minus_the_p_value(law: str, p: float) -> None:
    found = TABLE_2[law]
    assert found.z.p == pytest.approx(1 - found.z.inside, abs=1e-15)
    assert round(found.z.p, 3) == p
    assert abs(found.printed_p - found.z.inside) < 0.002


def test_the_printed_p_of_the_third_law_fits_neither_way() -> None:
    law = TABLE_2["third"]
    assert (f"{law.z.inside:.3f}", f"{normal_inside(law.printed_z):.3f}") == ("0.551", "0.553")
    assert law.printed_p == 0.552


def test_the_two_sided_limit_is_stricter_than_the_one_sided_hypothesis() -> None:
    assert normal_two_sided(1.96) == pytest.approx(0.05, abs=1e-4)
    assert normal_two_sided(1.645) / 2 == pytest.approx(0.05, abs=1e-4)
    assert TABLE_2["first"].z.z > 1.96 and abs(TABLE_2["third"].z.z) < 1.645


def test_the_columns_without_heading_are_before_after_and_gain() -> None:
    assert "pre_mean,pre_sd,post_mean,post_sd,gain_mean,gain_sd" in text("table-2.csv")
    for law in TABLE_2.values():
        for group in (law.experimental, law.control):
            assert group.gain.mean == pytest.approx(group.after.mean - group.before.mean, abs=1e-3)
            # and the gain's deviation is possible: its correlation lies between −1 and 1
            shared = group.before.sd**2 + group.after.sd**2 - group.gain.sd**2
            assert abs(shared / 2) < group.before.sd * group.after.sd


def test_eleven_of_fifteen_questions_are_reported() -> None:
    assert sum(law.control.of for law in TABLE_2.values()) == 11


def test_the_deviation_in_table_iii_is_impossible() -> None:
    control = TABLE_3["third"].control
    largest = largest_deviation(control.mean + 0.0005, control.n, 2)
    assert round(largest, 3) == 0.554
    assert control.sd - 0.0005 > largest
    total = whole_total(control.mean, control.n)
    assert total == 11
    possible = [
        stdev([2] * twos + [1] * (total - 2 * twos) + [0] * (control.n - total + twos))
        for twos in range(total // 2 + 1)
    ]
    assert round(max(possible), 3) == 0.539


def test_one_student_of_62_had_marks_for_the_third_law() -> None:
    group = TABLE_3["third"].experimental
    fitting = [
        marks
        for marks in combinations_with_replacement((0, 1, 2), 4)  # nobody else can have any
        if sum(marks) == whole_total(group.mean, group.n)
        and round(stdev([*marks, *[0] * (group.n - 4)]), 3) == group.sd
    ]
    assert fitting == [(0, 0, 0, 2)]
