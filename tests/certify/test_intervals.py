"""Intervals of decimals hold what Arb's balls say, and prove the same without Arb."""

from __future__ import annotations

import json
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction
from typing import Any

import pytest
from flint import arb, ctx, fmpq
from hypothesis import given
from hypothesis import strategies as st

from sim.certify.numbers.intervals import Interval
from sim.certify.numbers.rounding import context
from tests import registry
from tests.certify.held import NO_BOUND, misses

numbers = st.floats(-50, 50, allow_subnormal=False)
widths = st.sampled_from([0.0, 0.0, 1e-30, 1e-9, 0.01, 3.0])
digits = st.sampled_from([60, 160, 320])

FUNCTIONS: dict[str, Any] = {
    name: lambda x, name=name: getattr(x, name)()
    for name in ("exp", "sin", "cos", "sinh", "cosh", "sqrt", "log", "acos", "acosh")
}
OPERATIONS: dict[str, Any] = {
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": lambda x, y: x / y,
    "union": lambda x, y: x.union(y),
}


@pytest.fixture(autouse=True)
def _precision() -> Any:
    before = ctx.prec, context.prec
    yield
    ctx.prec, context.prec = before


def both(middle: float, radius: float, bits: int) -> tuple[Interval, Any]:
    """The same input on both sides; Arb with many more digits, as a point of the interval."""
    context.prec, ctx.prec = bits, 4 * bits
    return Interval(middle, radius), arb(middle)


def holds(ours: Interval, exact: Any) -> bool:
    """Is all of Arb's small ball inside? What has no bound is no claim."""
    if not exact.is_finite() or not ours.is_finite():
        return True
    low, high = (fmpq(*Fraction(end).as_integer_ratio()) for end in (ours.low, ours.high))
    return bool(arb(low) <= exact.upper() and exact.lower() <= arb(high))


@given(numbers, widths, digits, st.sampled_from(sorted(FUNCTIONS)), st.floats(-1, 1))
def test_a_function_of_an_interval_holds_that_of_every_number_in_it(
    middle: float, radius: float, bits: int, name: str, inside: float
) -> None:
    if name == "acos":
        middle = max(-0.999, min(0.999, middle / 50))
    ours, exact = both(middle, radius, bits)
    number = exact + arb(radius) * arb(inside)
    if name == "acosh" and not number > 1:
        return
    assert holds(FUNCTIONS[name](ours), FUNCTIONS[name](number))


@given(numbers, widths, numbers, widths, digits, st.sampled_from(sorted(OPERATIONS)))
def test_an_operation_on_intervals_holds_that_of_every_pair(
    a: float, wide_a: float, b: float, wide_b: float, bits: int, name: str
) -> None:
    (one, x), (other, y) = both(a, wide_a, bits), both(b, wide_b, bits)
    found = OPERATIONS[name](one, other)
    for sign in (-1, 0, 1):
        u, v = x + sign * arb(wide_a), y - sign * arb(wide_b)
        if name == "union":
            assert holds(found, u) and holds(found, v)
        else:
            assert holds(found, OPERATIONS[name](u, v))


@given(numbers, digits, st.sampled_from(["exp", "sin", "cos"]))
def test_of_a_number_nearly_all_digits_are_kept(middle: float, bits: int, name: str) -> None:
    ours, _ = both(middle, 0.0, bits)
    found = FUNCTIONS[name](ours)
    assert found.high - found.low <= Decimal(2) ** (8 - bits) * max(1, abs(found.high))


def test_a_crest_counts_only_where_it_lies_inside() -> None:
    context.prec = 160
    quarter = Interval.pi() / 2
    assert quarter.sin().high == 1
    assert (quarter - Fraction(1, 1000)).sin().high < 1
    assert Interval(1.5, 0.2).sin().high == 1 and Interval(4.7, 0.2).sin().low == -1
    assert Interval(0, 4).cos().low == -1 and Interval(0, 4).cos().high == 1


def test_pi_is_arbs() -> None:
    for bits in (53, 160, 5120):
        context.prec, ctx.prec = bits, 2 * bits
        ours = Interval.pi()
        assert holds(ours, arb.pi()) and ours.high - ours.low < Decimal(2) ** (4 - bits)


def test_a_comparison_is_true_only_if_it_is_for_every_choice() -> None:
    one, other = Interval(1, 0.5), Interval(1.75, 0.5)
    assert not one < other and not one > other and one != other
    assert one < 2 and one > 0 and Interval(3) == 3


def test_without_arb_every_scene_has_the_same_certificate_with_bounds_of_its_own() -> None:
    """In a process that has no python-flint: all scenes, against the oracle with forty digits."""
    code = (
        "import sys, json; sys.modules['flint'] = None\n"
        "from sim.certify.certificate import certify, document\n"
        "from sim.certify.numbers.arithmetic import ARB\n"
        "from tests import registry\n"
        "assert not ARB\n"
        "print(json.dumps({n: document(certify(registry.scene(n))) for n in registry.PATHS}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    proved = set()
    for name, found in json.loads(done.stdout).items():
        if found["final"]["x"]:
            assert misses(registry.scene(name), found) == [], name
            proved.add(name)
            assert found["order"] == "proved"
        else:
            assert found["reason"], name
    assert proved == set(registry.PATHS) - NO_BOUND


def test_the_command_proves_digits_without_arb_too() -> None:
    code = (
        "import sys; sys.modules['flint'] = None\n"
        "from sim.cli import main; main(['run', 'tests/scenes/instant.yml', '--certify'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "The order of the events is proved." in done.stdout
