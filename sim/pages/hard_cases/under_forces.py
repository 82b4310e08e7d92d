"""Hard cases under drag, magnets, springs and pushes, and runs that go on for long."""

from __future__ import annotations

import math
import random

from sim.pages.hard_cases.row import Expected, G, HardCase, at, row, scene, speeds
from sim.pages.hard_cases.under_effects import BITS, SIN, friction, incline

W_DRAG = math.sqrt(1000 - 0.1**2)  # 1/s: sqrt(k/mu) with k = 500, mu = 0.5, b/m = 0.2
R0, U0, MU, C = 0.4, 1.0, 2 / 3, 0.01
E_MAG = 0.5 * MU * U0**2 + C / (2 * R0**2)
T_MIN = R0 * U0 * MU / (2 * E_MAG)
R_MIN = math.sqrt(C / (2 * E_MAG))
TWO = {"A": at(0, "0.5"), "B": at("0.6", "-0.5", 2)}
MAGNETS = {"magnets": {"between": ["A", "B"], "strength": C, "power": 3}}
W_SPRING = math.sqrt(30 / MU)
SPRING = {"spring": {"between": ["A", "B"], "stiffness": 30, "length": R0}}
TWO_SPRING = {"A": at(0, 1), "B": at("0.6", "-0.5", 2)}

FORCES = [
    HardCase(
        "linear-drag",
        "Drag b v: speed and way fade with e^(−b t/m).",
        scene({"A": at(0, 2, "0.5")}, 3, {"drag": {"linear": "0.25"}}),
        (*speeds(2 * math.exp(-1.5), within=BITS),
         Expected("x.A", 4 * (1 - math.exp(-1.5)), BITS)),
        "Stokes; closed form.",
    ),
    HardCase(
        "quadratic-drag",
        "Drag c v²: v₀/(1 + c v₀ t/m), a way that grows for ever.",
        scene({"A": at(0, 2, "0.5")}, 3, {"drag": {"quadratic": "0.25"}}),
        (*speeds(0.5, within=BITS), Expected("x.A", 2 * math.log(4), BITS)),
        "Newton; closed form.",
    ),
    HardCase(
        "falling-in-air",
        "Down a slope against c v²: v_t tanh(a t/v_t).",
        scene({"A": at(0, 0, 1)}, 2, incline(), {"drag": {"quadratic": "0.5"}}),
        speeds(math.sqrt(2 * G * SIN) * math.tanh(2 * G * SIN / math.sqrt(2 * G * SIN)),
               within=1e-14),
        "Solution of m v' = m a − c v²; the power series keeps 10⁻¹⁵.",
    ),
    HardCase(
        "drag-inside-a-contact",
        "Equal drag on both carts adds to the damping of their contact.",
        row([1, -1], math.pi / W_DRAG, {"drag": {"linear": "0.2"}},
            contact={"restitution": 1, "stiffness": 500}),
        (Expected("v.B-A", 2 * math.exp(-0.1 * math.pi / W_DRAG), 1e-13),),
        "β = b/2m: e = exp(−βπ/w), w² = k/μ − β²; read at the instant of separation.",
    ),
    HardCase(
        "magnets-turning-point",
        "Magnets C/r³: the carts come as near as (C/((n − 1) E))^(1/(n − 1)).",
        scene(TWO, T_MIN, MAGNETS),
        (Expected("x.B-A", R_MIN + 0.2, 1e-14), Expected("v.B-A", 0, 1e-12)),
        "Energy: at the turning point all of it is C/(2 r²).",
    ),
    HardCase(
        "magnets-at-any-time",
        "Magnets C/r³ have a closed form: r² = r₀² + 2 r₀ r₀' t + (2 E/μ) t².",
        scene(TWO, 1.5, MAGNETS),
        (Expected("x.B-A", math.sqrt(R0**2 - 2 * R0 * U0 * 1.5 + 2 * E_MAG / MU * 1.5**2) + 0.2,
                  1e-13), Expected("energy", 0.375 + C / (2 * R0**2), 1e-14)),
        "d²(r²)/dt² = 4 E/μ is constant for n = 3.",
    ),
    HardCase(
        "spring-pair-half-a-period",
        "Two carts on a spring: half a period later they have exchanged their relative motion.",
        scene(TWO_SPRING, math.pi / W_SPRING, SPRING),
        (*speeds(-1, 0.5, within=1e-14), Expected("x.B-A", 0.6, 1e-14)),
        "ω = √(k/μ); V = 0.",
    ),
    HardCase(
        "spring-pair-quarter-period",
        "A quarter period: nearest, at the natural length minus u/ω.",
        scene(TWO_SPRING, 0.5 * math.pi / W_SPRING, SPRING),
        (*speeds(0, 0, within=1e-14), Expected("x.B-A", 0.6 - 1.5 / W_SPRING, 1e-14)),
        "Harmonic oscillation.",
    ),
    HardCase(
        "a-thousand-swings",
        "A thousand periods later everything is as at the start.",
        scene(TWO_SPRING, 2000 * math.pi / W_SPRING, SPRING),
        (*speeds(1, -0.5, within=1e-10), Expected("energy", 0.75, 1e-11)),
        "Each step rounds at 10⁻¹⁶ and the phase adds up: 10⁴ steps, some 10⁻¹².",
    ),
    HardCase(
        "release-from-rest",
        "An exploder of 6 J between 1 kg and 3 kg.",
        scene({"A": at(0), "B": at("0.2", 0, 3)}, 1,
              {"release": {"between": ["A", "B"], "energy": 6}}),
        (*speeds(-3, 1, within=BITS), Expected("work.release", 6, 0)),
        "Equal and opposite momenta; 4.5 J and 1.5 J.",
    ),
    HardCase(
        "release-on-the-way",
        "The same at t = 1 s, both moving at 0.5 m/s until then.",
        scene({"A": at(0, "0.5"), "B": at("0.2", "0.5", 3)}, 2,
              {"release": {"between": ["A", "B"], "energy": 6, "at": 1}}),
        (*speeds(-2.5, 1.5, within=BITS), Expected("x.A", 0.5 - 2.5, BITS),
         Expected("x.B", 0.7 + 1.5, BITS)),
        "Galileo: the same parting, seen from a moving train.",
    ),
    HardCase(
        "push-impulse",
        "2 N for half a second on half a kilogram.",
        scene({"A": at(0, 0, "0.5")}, 2,
              {"push": {"cart": "A", "force": 2, "from": "0.5", "until": 1}}),
        (*speeds(2, within=BITS), Expected("x.A", 0.5 + 2, BITS), Expected("work.push", 1, BITS)),
        "F t = m v; work = half m v².",
    ),
    HardCase(
        "push-then-friction",
        "What a push gives, friction takes: the work of both adds to nought.",
        scene({"A": at(0)}, 20, friction(0.1),
              {"push": {"cart": "A", "force": 3, "until": 1}}),
        (*speeds(0, within=0), Expected("x.A", 0.5 * (3 - 0.1 * G) * 3 / (0.1 * G), 1e-14),
         Expected("work.push", 1.5 * (3 - 0.1 * G), 1e-14)),
        "F s₁ = μ m g s, s₁ = half a t².",
    ),
]  # fmt: skip

W_SOFT = math.sqrt(500.0)
PERIOD = 2 * (50 + math.pi / W_SOFT)
MANY = 1e6 // PERIOD


def fifty() -> HardCase:
    """Jepsen's gas: equal carts only exchange their names."""
    dice, n, room, until = random.Random(2), 50, 4.0, 20.0
    x = sorted(round(dice.uniform(0, room), 6) for _ in range(n))
    v = [round(dice.uniform(-1, 1), 6) for _ in range(n)]
    lines = []
    for start, speed in zip(x, v, strict=True):
        unfolded = (start + speed * until) % (2 * room)
        lines.append(min(unfolded, 2 * room - unfolded))
    return HardCase(
        "jepsen-50",
        "Fifty equal carts in a box: their lines go straight through each other.",
        scene(
            {f"c{k}": at(repr(x[k]), repr(v[k]), 1, 0) for k in range(n)}, until,
            track={"left": "wall", "right": "wall", "length": room}, contact={"law": "instant"},
        ),
        tuple(Expected(f"x.c{k}", line, 1e-11) for k, line in enumerate(sorted(lines))),
        "Jepsen, J. Math. Phys. 6 (1965) 405; 5,000 additions of 10⁻¹⁶ m.",
        events=False,
    )  # fmt: skip


LONG = [
    HardCase(
        "a-million-seconds",
        "One soft cart between walls for 10⁶ s is where its period says.",
        scene(
            {"A": at("0.6", "0.02")}, MANY * PERIOD,
            track={"left": "wall", "right": "wall", "length": "1.2"},
            contact={"restitution": 1, "stiffness": 500},
        ),
        (Expected("x.A", 0.6, 1e-9), *speeds(0.02, within=1e-12)),
        "Period 2 (L/v + π/w); the end time itself is known to 10⁻¹⁰ s.",
        events=False,
    ),
    fifty(),
]  # fmt: skip
