"""Rows of bodies that push each other: the series holds the truth, and so do the certificates."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from math import cos, pi, sqrt
from random import Random
from typing import Any

import pytest
from flint import arb, ctx
from mpmath import expm, matrix, mp, mpf

from sim.certify.certificate import certify, document
from sim.certify.equations import RowEquations, State
from sim.certify.numbers.balls import ZERO, bounds, exact
from sim.certify.oscillation import Line
from sim.certify.series import Piece
from sim.certify.transport import Transport
from sim.dynamics.loop.run import run
from sim.scene import read_scene
from tests.certify.held import misses
from tests.certify.random_scenes import touching

SEEDS = (1, 11, 18, 23, 35, 49)
"""Of the rows in `random_scenes` some that are done in a second, their oracle included."""

BITS = 200


@pytest.fixture(autouse=True)
def _precision() -> Iterator[None]:
    before = ctx.prec
    ctx.prec = BITS
    yield
    ctx.prec = before


def row(seed: int) -> tuple[RowEquations, State, list[list[float]]]:
    """Three bodies, two gaps, all numbers doubles: the same as matrix of y = (x, v, 1)."""
    dice = Random(seed)
    k = [dice.uniform(50, 500) for _ in range(2)]
    c = [dice.choice([0.0, dice.uniform(0, 5)]) for _ in range(2)]
    rest = [dice.uniform(-0.01, 0.01) for _ in range(2)]
    light = [dice.uniform(0.3, 3) for _ in range(3)]
    load = [dice.uniform(-1, 1) for _ in range(3)]
    drag = [dice.choice([0.0, dice.uniform(0, 2)]) for _ in range(3)]
    x, v = ([dice.uniform(-0.02, 0.02) for _ in range(3)] for _ in range(2))
    lines = tuple((Line(exact(k[j]), exact(c[j]), exact(rest[j])),) for j in range(2))
    start = State(
        tuple(exact(x[j]) - exact(x[j + 1]) for j in range(2)),
        tuple(exact(v[j]) - exact(v[j + 1]) for j in range(2)),
        (ZERO, ZERO, ZERO),
        tuple(map(exact, v)),
    )
    pulls = tuple(exact(load[j]) - exact(load[j + 1]) for j in range(2))
    found = RowEquations(
        lines, tuple(map(exact, light)), tuple(map(exact, load)), pulls, tuple(map(exact, drag))
    )
    return found, start, [k, c, rest, light, load, drag, x, v]


def truth(numbers: list[list[float]], t: mpf) -> list[mpf]:
    """x and v of the three bodies after t [s]: the exponential of a matrix, with 80 digits."""
    k, c, rest, light, load, drag, x, v = ([mpf(one) for one in part] for part in numbers)
    a = matrix(7, 7)
    for j in range(3):
        a[j, 3 + j] = 1
        a[3 + j, 3 + j] -= drag[j]
        a[3 + j, 6] += load[j]
        for gap, way in ((j - 1, 1), (j, -1)):  # its force pushes the right body to the right
            if 0 <= gap < 2:
                push = way * light[j]
                for place, sign in ((gap, 1), (gap + 1, -1)):
                    a[3 + j, place] += sign * push * k[gap]
                    a[3 + j, 3 + place] += sign * push * c[gap]
                a[3 + j, 6] -= push * k[gap] * rest[gap]
    end = expm(a * t, method="taylor") * matrix([*x, *v, mpf(1)])
    return [end[j] for j in range(6)]


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("bits", [20, 60, BITS])
def test_a_piece_holds_the_exponential_of_its_matrix(seed: int, bits: int) -> None:
    """With few bits the series is short, and its remainder is most of the ball: still it holds."""
    equations, start, numbers = row(seed)
    ctx.prec = bits
    omega, rate = equations.rates()
    length = exact(1.0 / float(rate))
    piece = Piece(equations, start, length, omega, rate, balanced=())
    ctx.prec = 300
    with mp.workdps(80):
        for share in (0.25, 1.0, 1.25):
            tau = float(share * float(length))
            end = truth(numbers, mpf(tau))
            for j in range(3):
                way, speed = piece.displacement(j).at(exact(tau)), piece.speed(j).at(exact(tau))
                assert way.contains(arb(mp.nstr(end[j] - mpf(numbers[6][j]), 75)))
                assert speed.contains(arb(mp.nstr(end[3 + j], 75)))
                slope = piece.displacement(j).slope().at(exact(tau))
                assert slope.contains(arb(mp.nstr(end[3 + j], 75)))


def test_a_bound_of_what_is_left_out_is_not_much_more_than_that() -> None:
    equations, start, numbers = row(2)
    omega, rate = equations.rates()
    length = exact(1.0 / float(rate))
    ctx.prec = 40
    short = Piece(equations, start, length, omega, rate)
    ctx.prec = 300
    with mp.workdps(80):
        end = truth(numbers, mpf(float(length)))
    terms = sum(one * length**n for n, one in enumerate(short.v[0]))
    left_out = abs(arb(mp.nstr(end[3], 75)) - terms.mid()).upper()
    bound = abs(short.speed(0).tails[0]).upper() + terms.rad()
    assert left_out < bound < 1e-9


def test_a_signal_that_begins_at_nought_has_the_same_zeros_without_its_factor() -> None:
    equations, start, _ = row(1)
    still = State((ZERO, start.o[1]), (start.s[0], start.s[1]), start.x, start.v)
    omega, rate = equations.rates()
    piece = Piece(equations, still, exact(1.0 / float(rate)), omega, rate, balanced=())
    overlap = piece.overlap(0, (arb(1), ZERO, ZERO))
    bare = overlap.begun(piece.reach)
    for share in (0.1, 0.5, 1.0):
        tau = exact(share * float(piece.length))
        assert (bare.at(tau) * tau).overlaps(overlap.at(tau))
        product = bare.slope().at(tau) * tau + bare.at(tau)
        assert product.overlaps(overlap.slope().at(tau))


def test_a_hundred_pieces_on_a_set_is_no_wider_than_the_motion_makes_it() -> None:
    """Boxed in piece by piece it would be some 10¹⁰ times as wide."""
    equations, start, numbers = row(3)
    omega, rate = equations.rates()
    length = exact(1.0 / float(rate))
    wide = arb(0, 1e-12)
    known = State(tuple(o + wide for o in start.o), start.s, start.x, start.v)
    far = Transport(equations, known, length, omega, rate).state(100)
    assert all(ball.rad() < 1e-10 for ball in (*far.o, *far.s))
    with mp.workdps(80):
        end = truth(numbers, 100 * mpf(float(length)))
    for j in range(2):
        assert far.o[j].contains(arb(mp.nstr(end[j] - end[j + 1], 75)))


@pytest.mark.parametrize("seed", SEEDS)
def test_forty_digits_of_a_random_row_lie_inside_its_certificate(seed: int) -> None:
    scene = read_scene(touching(seed))
    found = document(certify(scene))
    assert found["order"] == "proved", found["reason"]
    assert misses(scene, found) == []


def test_a_gap_that_opens_at_first_is_watched_for_the_push_that_comes_later() -> None:
    """F leans on the wall and would roll away, until A's push arrives: found among random rows."""
    scene = read_scene(touching(223))
    found, done = certify(scene), run(scene)
    events = [(event.kind, event.bodies) for event in done.record.events]
    assert [(event.kind, event.bodies) for event in found.events] == events
    for name, v in zip("ABCDEF", done.v, strict=True):
        low, high = bounds(found.v[name])
        assert low - 1e-13 <= v <= high + 1e-13


def test_a_cradle_is_certified_and_mirrored_it_is_the_same() -> None:
    """From the left or from the right: bounds of the mirrored carts hold each other's middles."""
    v = {}
    for left in (True, False):
        order = (0, 1, 2) if left else (2, 1, 0)
        carts = {
            "ABC"[k]: {"mass": 0.5, "position": 0.5 + 0.2 * k, "velocity": 0} for k in range(3)
        }
        carts["ABC"[order[0]]]["velocity"] = 1 if left else -1
        scene = {"carts": carts, "until": 1, "contact": {"restitution": 0.9, "stiffness": 400}}
        found = document(certify(read_scene(scene)))
        assert found["order"] == "proved"
        v[left] = [found["final"]["v"]["ABC"[k]] for k in order]
    for (low, high), (least, most) in zip(v[True], v[False], strict=True):
        assert Fraction(float(low)) <= -Fraction(float(least)) + Fraction(1, 10**15)
        assert -Fraction(float(most)) <= Fraction(float(high)) + Fraction(1, 10**15)


def test_a_tolerant_spring_holds_every_frequency_that_it_allows() -> None:
    def scene(mass: object) -> dict[str, Any]:
        return {
            "carts": {"A": {"mass": mass, "position": 1.1}},
            "track": {"length": 1.8, "left": "wall"},
            "effects": [{"spring": {"between": ["left", "A"], "stiffness": 2, "length": 0.8}}],
            "until": 2,
        }

    low, high = map(float, document(certify(read_scene(scene("0.50(1) kg"))))["final"]["x"]["A"])
    for m in (0.49, 0.495, 0.5, 0.507, 0.51):
        assert low <= 0.9 + 0.2 * cos(sqrt(2 / m) * 2) <= high
    assert high - low < 0.03  # 0.0135, and what a ball forgets


def test_without_arb_a_row_has_the_same_certificate() -> None:
    code = (
        "import sys, json; sys.modules['flint'] = None\n"
        "from sim.certify.certificate import certify, document\n"
        "from sim.scene import read_scene\n"
        "from tests.certify.random_scenes import touching\n"
        "print(json.dumps(document(certify(read_scene(touching(18))))))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    found, scene = json.loads(done.stdout), read_scene(touching(18))
    assert found["order"] == "proved" and misses(scene, found) == []


def test_a_spring_alone_swings_a_million_times_in_its_certificate() -> None:
    """By a formula, not by pieces of a series: as many swings as a scene asks for."""
    k, mass, swings = 1.0, 0.25, 1_000_000
    scene = read_scene({
        "carts": {"A": {"mass": mass, "position": 0.3}, "B": {"mass": 1e12, "position": 1.5}},
        "effects": [{"spring": {"between": ["A", "B"], "stiffness": k, "length": 0.9}}],
        "until": swings * pi * sqrt(mass / k) * 2,
    })  # fmt: skip
    found = certify(scene)
    with mp.workdps(60):
        m, big, until = mpf(mass), mpf(10) ** 12, mpf(scene.until)
        w = mp.sqrt(k * (1 / m + 1 / big))
        away = mpf(scene.gaps[1]) - mpf(0.9)  # m, how far the spring is pulled at first
        v = away * w * mp.sin(w * until) * big / (m + big)
    low, high = bounds(found.v["A"])
    assert found.proved and low <= float(v) <= high
    assert high - low < 1e-9  # the gap is known to an ulp, and swings carry it on
