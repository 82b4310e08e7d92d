"""Hard cases with dry friction and slopes: staying, sliding, turning round."""

from __future__ import annotations

import math
from typing import Any

from sim.pages.hard_cases.row import ULP, Expected, G, HardCase, at, scene, speeds

BITS = 16 * ULP
"""A closed form evaluated twice, in two orders of operations, for numbers of about 1."""

SLOPE = 0.2  # rad
SIN, COS = math.sin(SLOPE), math.cos(SLOPE)


def incline(angle: Any = SLOPE) -> dict[str, Any]:
    """One entry of the list of effects."""
    return {"incline": {"angle": angle}}


def friction(coefficient: float, static: float | None = None) -> dict[str, Any]:
    """One entry of the list of effects."""
    body = {"coefficient": coefficient}
    return {"friction": body if static is None else body | {"static": static}}


def back_at_start(mu: float) -> tuple[float, float]:
    """s and m/s of a cart sent uphill at 1 m/s, when it is back."""
    up, down = G * (SIN + mu * COS), G * (SIN - mu * COS)
    way = 0.5 / up
    return 1 / up + math.sqrt(2 * way / down), math.sqrt(2 * way * down)


def through_the_bumper(mu: float, k: float) -> float:
    """m. How far from the wall a cart stops that runs into it at 1 m/s and rubs."""
    force = mu * G
    deepest = (-force + math.sqrt(force**2 + k)) / k
    return (1 - 4 * force * deepest) / (2 * force)


BACK, SPEED_BACK = back_at_start(0.1)

DRY = [
    HardCase(
        "friction-stops",
        "A cart at 1 m/s stops after v²/(2 μ g) and stays.",
        scene({"A": at(0, 1)}, 10, friction(0.05)),
        (Expected("x.A", 1 / (0.1 * G), BITS), *speeds(0, within=0),
         Expected("work.friction", -0.5, BITS)),
        "Coulomb: all of the kinetic energy is rubbed away; v is nought exactly.",
    ),
    HardCase(
        "friction-in-a-bumper",
        "A cart runs into a wall's bumper while it rubs.",
        scene(
            {"A": at("0.9", 1)}, 10, friction(0.02),
            track={"right": "wall", "length": 1}, contact={"restitution": 1, "stiffness": 400},
        ),
        (Expected("x.A", 0.9 - through_the_bumper(0.02, 400), 1e-13), *speeds(0, within=0)),
        "v_out² = u² − 4 F x_m/m with the greatest overlap x_m; then v_out²/(2 μ g) to the stop.",
    ),
    HardCase(
        "sticks-below-the-angle-of-friction",
        "On a slope below tan θ = μ a cart at rest stays at rest.",
        scene({"A": at(1)}, 1e4, incline(), friction(0.21)),
        (*speeds(0, within=0), Expected("x.A", 1, 0)),
        "tan 0.2 = 0.2027 < 0.21; nothing moves, not even by rounding.",
    ),
    HardCase(
        "slides-above-the-angle-of-friction",
        "Above it the cart slides down with g (sin θ − μ cos θ).",
        scene({"A": at(1)}, 1, incline(), friction(0.2)),
        speeds(G * (SIN - 0.2 * COS), within=BITS),
        "tan 0.2 = 0.2027 > 0.2; Newton's second law along the track.",
    ),
    HardCase(
        "static-holds-what-kinetic-would-not",
        "Between μ and μ_s a cart at rest stays, and one that moves speeds up.",
        scene({"A": at(0), "B": at(1, "0.1")}, 1, incline(), friction(0.15, 0.25)),
        speeds(0, 0.1 + G * (SIN - 0.15 * COS), within=BITS),
        "0.15 < tan 0.2 < 0.25.",
    ),
    HardCase(
        "uphill-and-stuck",
        "Sent uphill with μ > tan θ a cart stops there for good.",
        scene({"A": at(0, -1)}, 100, incline(), friction(0.3)),
        (Expected("x.A", -0.5 / (G * (SIN + 0.3 * COS)), BITS), *speeds(0, within=0)),
        "v²/(2 g (sin θ + μ cos θ)); static friction then holds it.",
    ),
    HardCase(
        "uphill-and-back",
        "With μ < tan θ it comes back, slower.",
        scene({"A": at(0, -1)}, BACK, incline(), friction(0.1)),
        (Expected("x.A", 0, 1e-15), *speeds(SPEED_BACK, within=BITS)),
        "v' = v √((sin θ − μ cos θ)/(sin θ + μ cos θ)).",
    ),
    HardCase(
        "too-weak-a-push",
        "A push below μ_s m g moves nothing.",
        scene({"A": at(0)}, 5, friction(0.1, 0.2), {"push": {"cart": "A", "force": 1.9}}),
        speeds(0, within=0),
        "μ_s m g = 1.962 N.",
    ),
    HardCase(
        "zeno-on-a-slope",
        "A cart bounces ever lower on the wall below; all bounces end at a finite time.",
        scene(
            {"A": at("0.5", 0)}, 3, incline("30 deg"), gravity=10,
            track={"right": "wall", "length": 1},
            contact={"law": "instant", "restitution": "0.5"},
        ),
        (Expected("last.contact", 0.4 * 3, 2e-12), *speeds(0, within=1e-15),
         Expected("x.A", 0.9, 1e-15)),
        "t = t₀ (1 + 2 e/(1 − e)), t₀ = √(2 h/a) = 0.4 s; below 10⁻¹² m/s it rests.",
    ),
    HardCase(
        "rest-on-a-soft-wall",
        "On a bumper it ends pressed in by m a/k.",
        scene(
            {"A": at("0.5", 0)}, 60, incline("30 deg"), gravity=10,
            track={"right": "wall", "length": 1},
            contact={"law": "paper", "restitution": "0.5", "stiffness": 500},
        ),
        (Expected("x.A", 0.91, 1e-14), *speeds(0, within=1e-13)),
        "m g sin θ = k d: d = 5 N / 500 N/m.",
    ),
    HardCase(
        "resting-on-a-slope",
        "A cart that rests on its bumper keeps resting.",
        scene(
            {"A": at("0.91", 0)}, 1000, incline("30 deg"), gravity=10,
            track={"right": "wall", "length": 1}, start={"overlap": True},
            contact={"restitution": 1, "stiffness": 500},
        ),
        (Expected("x.A", 0.91, 1e-14), *speeds(0, within=1e-13)),
        "Equilibrium to the last bit of sin 30°; elastic, so the rest of it swings on.",
    ),
]  # fmt: skip
