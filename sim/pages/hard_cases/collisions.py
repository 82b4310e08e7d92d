"""Hard cases of carts that only meet: what breaks step-by-step engines, what must come out, why."""

from __future__ import annotations

import math
from typing import Any

from sim.pages.hard_cases.row import (
    ULP,
    Expected,
    HardCase,
    at,
    row,
    scene,
    speeds,
    ten_to,
)


def pi_billiard(digits: int, **contact: Any) -> dict[str, Any]:
    """A light cart at rest between a wall and a cart 100^digits times as heavy that comes in."""
    carts = {"light": at(1, 0, 1, 0), "heavy": at(2, -1, 100**digits, 0)}
    made: dict[str, Any] = scene(carts, 1e6, track={"left": "wall"}, contact=contact)
    return made


def pi_digits(digits: int) -> int:
    """Impacts before a wall."""
    return math.ceil(math.pi / math.atan(10.0**-digits)) - 1


PI = [
    HardCase(
        f"pi-hard-{n}",
        f"A cart of {ten_to(2 * n)} kg, one of 1 kg and a wall: their impacts count digits of π.",
        pi_billiard(n, law="instant"),
        (Expected("count.contact", pi_digits(n), 0),),
        "Galperin, Regular and Chaotic Dynamics 8 (2003) 375: ceil(π / atan 10⁻ⁿ) − 1; a count.",
        events=n < 3,
    )
    for n in range(5)
] + [
    HardCase(
        f"pi-soft-{n}",
        f"Bumpers of {ten_to(log_k)} N/m count the same digits: no two contacts overlap in time.",
        pi_billiard(n, stiffness=10.0**log_k),
        (Expected("count.contact", pi_digits(n), 0),),
        "k > π² (M/m)² m V²/x₀² keeps every contact before the wall alone; a count.",
        events=n < 3,
    )
    for n, log_k in ((1, 5), (2, 10), (3, 14), (4, 18))
]  # fmt: skip


def ratio(digits: int) -> HardCase:
    """Very unequal masses."""
    e, u, big = 0.8, 1.0, 10.0**digits
    centre = big * u / (big + 1)
    return HardCase(
        f"mass-ratio-{big:.0e}",
        f"A cart of {ten_to(digits)} kg hits one of 1 kg at rest.",
        scene(
            {"A": at(0, 1, big), "B": at("0.5", 0, 1)}, 1,
            contact={"restitution": "0.8", "stiffness": 5000},
        ),
        speeds(centre - e * (1 - centre), centre * (1 + e), within=4 * ULP),
        "v' = V + e (V − v) with V of the common centre; two units in the last place.",
    )  # fmt: skip


def three_unevenly(e: str) -> dict[str, Any]:
    """One at rest 5 cm off the middle of two that come in: from the middle both would be struck at
    one instant, and part after two impacts at any e."""
    carts = {"A": at("0.5", 1), "B": at("0.85"), "C": at("1.1", -1)}
    made: dict[str, Any] = scene(carts, 20, contact={"law": "instant", "restitution": e})
    return made


IMPACTS = [
    ratio(9),
    ratio(18),
    HardCase(
        "microsecond-in-a-slow-flight",
        "Two carts at 10⁻⁹ m/s touch for a microsecond within a flight of 100 s.",
        scene(
            {"A": at(0, "1e-9"), "B": at("0.200000001", "-0.5e-9", 2)}, 100,
            contact={"restitution": "0.8", "stiffness": 1e13},
        ),
        speeds(-0.8e-9, 0.4e-9, within=1e-24),
        "V = 0, so every velocity turns and keeps 0.8 of itself; two ulp of 10⁻⁹.",
    ),
    HardCase(
        "grazing",
        "One cart is faster by 10⁻¹² m/s than the next, touching one.",
        row(["1.000000000001", 1], 1, contact={"restitution": "0.5", "stiffness": 1e6}),
        speeds(1 + 0.25e-12, 1 + 0.75e-12, within=2 * ULP),
        "V = 1 + 0.5 × 10⁻¹², e = 0.5; velocities are stored to one ulp of 1.",
    ),
    HardCase(
        "restitution-1e-12",
        "Hardly any restitution is still delivered.",
        row([1, -1], 5, gap="0.6", contact={"law": "paper", "restitution": "1e-12"}),
        (Expected("v.B-A", 2e-12, 4 * ULP),),
        "Separation speed e u = 2 × 10⁻¹² m/s, from velocities stored to an ulp of 1.",
    ),
    HardCase(
        "restitution-0",
        "Without restitution two carts go on together.",
        scene({"A": at(0, 1), "B": at("0.5", 0, 3)}, 5, contact={"restitution": 0}),
        (*speeds(0.25, 0.25, within=4 * ULP), Expected("warmed", 0.375, 4 * ULP)),
        "Conservation of momentum: m₁ u/(m₁ + m₂); half μ u² warms the bumpers.",
    ),
    HardCase(
        "collapse-just-above",
        "Just above the limit, at e = 0.075, three equal carts hit each other 17 times and part.",
        three_unevenly("0.075"),
        (Expected("count.contact", 17, 0), Expected("x.B-A", 0.200000024763677, 1e-14),
         Expected("x.C-B", 0.200000000138997, 1e-14),
         *speeds(-8.3252076826e-10, 4.1261418606e-10, 4.1990658220e-10, within=1e-16)),
        "One impact after the other, in 300 digits; McNamara & Young, Phys. Fluids A 4 (1992) 496: "
        "an end to the impacts from 7 − 4 √3 = 0.0718 on.",
    ),
    HardCase(
        "collapse-below",
        "At e = 0.05 three equal carts collapse: infinitely many impacts in 0.1214 s, and then "
        "one velocity.",
        three_unevenly("0.05"),
        (Expected("last.contact", 0.1 + 0.05 * 3 / 7, 2e-12), *speeds(0, 0, 0, within=1e-15),
         Expected("x.B-A", 0.2, 1e-12), Expected("x.C-B", 0.2, 1e-12)),
        "McNamara & Young: e < 7 − 4 √3; the momentum is nought. B stands d off the middle: "
        "t = 0.1 s + d (1 + e)/(2 − 2 e + √(1 − 14 e + e²))/(1 m/s). The run lists impacts until "
        "the rest of the series is below rounding.",
    ),
    HardCase(
        "triple-hit-paper",
        "Two carts meet in a third: each sees a fixed wall.",
        row([1, 0, -1], 5, gap="0.3", contact={"law": "paper", "restitution": "0.8"}),
        speeds(-0.854201911781, 0, 0.854201911781, within=1e-12),
        "e = exp(−π z/√(1 − z²)) with z = ζ √½; twelve digits printed.",
    ),
    HardCase(
        "triple-hit-bumper",
        "The bumper law returns its e in a symmetric triple hit too.",
        row([1, 0, -1], 5, gap="0.3", contact={"restitution": "0.5"}),
        speeds(-0.5, 0, 0.5, within=1e-14),
        "Hysteresis gives back e² of the energy at any mass.",
    ),
    HardCase(
        "start-in-overlap",
        "Two carts pressed together by 2 cm at rest fly apart.",
        scene(
            {"A": at(0), "B": at("0.18")}, 1,
            contact={"restitution": 1, "stiffness": 500}, start={"overlap": True},
        ),
        (*speeds(-math.sqrt(0.1), math.sqrt(0.1), within=1e-15), Expected("energy", 0.1, 1e-16)),
        "Half k d² = 0.1 J shared by two equal carts: v = √0.1 m/s.",
    ),
    HardCase(
        "far-from-the-origin",
        "A collision at x = 10⁹ m.",
        scene(
            {"A": at(10**9, 1), "B": at(f"{10**9}.8", "-0.5", 2)}, 1,
            contact={"restitution": "0.8", "stiffness": 500},
        ),
        speeds(-0.8, 0.4, within=4 * ULP),
        "Gaps come from the decimal text, so x does not matter; two ulp.",
    ),
    HardCase(
        "soft-springs-near-walls",
        "Two carts on very soft bumpers between near walls: everything touches at once.",
        scene(
            {"A": at("0.11", 1), "B": at("0.33", "-0.4", 2)}, 2,
            track={"left": "wall", "right": "wall", "length": "0.45"},
            contact={"restitution": 1, "stiffness": 5},
        ),
        (Expected("energy", 0.66, 1e-14), Expected("warmed", 0, 1e-15)),
        "Elastic: kinetic and spring energy together stay 0.66 J.",
    ),
]  # fmt: skip

ZERO_FIVE = [-0.132279485, -0.075329170, -0.031010829, 0.296217750, 0.942401733]
CRADLES = [
    HardCase(
        f"cradle-{len(out)}",
        f"{len(out)} touching carts on linear springs, the first comes in at 1 m/s.",
        row([1] + [0] * (len(out) - 1), 5, contact={"restitution": 1, "stiffness": 500}),
        speeds(*out, within=6e-10),
        "Integrated by DOP853 at 10⁻¹² and in 40 digits; nine digits printed.",
    )
    for out in (
        [-0.130261695, 0.150229569, 0.980032126],
        [-0.132275275, -0.064974765, 0.236977607, 0.960272433],
        ZERO_FIVE,
    )
] + [
    HardCase(
        f"hertz-cradle-{len(out)}",
        f"{len(out)} touching Hertz spheres, the first comes in at 1 m/s.",
        row([1] + [0] * (len(out) - 1), 1,
            contact={"law": "hertz", "restitution": 1, "stiffness": 1e5}),
        speeds(*out, within=6e-7),
        "Herrmann & Schmälzle, Am. J. Phys. 49 (1981) 761, redone by DOP853; six digits printed.",
    )
    for out in (
        [-0.070952, 0.076403, 0.994549],
        [-0.071085, -0.029626, 0.109739, 0.990973],
        [-0.071085, -0.030274, -0.014464, 0.127045, 0.988777],
    )
] + [
    HardCase(
        "cradle-spaced",
        "With gaps of 1.12 u √(m/k) the motion is handed on as by instant impacts.",
        row([1, 0, 0, 0], 5, gap="0.0501", contact={"restitution": 1, "stiffness": 500}),
        speeds(0, 0, 0, 1, within=1e-14),
        "Contacts no longer overlap from π/(2 √2) = 1.1107 on; a few ulp.",
    )
]  # fmt: skip
