"""The damping ζ of a law from the restitution e that it returns, as a ball.

`paper`, and `push-only-uncorrected`, which is printed so: ζ = L/√(π² + L²), L = −ln e.
`push-only`: φ cot φ = −(ln e)/2, beyond critical damping y coth y = −(ln e)/2, ζ = cosh y. That
root is found by Newton's method and then proved: the function falls, and has its two signs at the
ends of a short interval. See `sim.laws.dashpot` for where the formulas come from; nothing of it is
used.
"""

from __future__ import annotations

from collections.abc import Callable

from sim.certify.numbers.arithmetic import arb, ctx
from sim.certify.numbers.balls import Ball, NotProvableError, is_zero
from sim.scene.said import said

GUARD = 24
"""Bits that Newton's method may lose: the interval is so much wider than the last place."""


def to_zero_overlap(e: Ball) -> tuple[Ball, bool]:
    """ζ of a contact that ends at overlap 0, and whether it is critical."""
    if is_zero(e):
        return arb(1), True
    if is_zero(e - 1):
        return arb(0), False
    loss, half_turn = -e.log(), arb.pi()
    return loss / (half_turn * half_turn + loss * loss).sqrt(), False


def to_zero_force(e: Ball) -> tuple[Ball, bool]:
    """ζ of a contact that ends at no force."""
    if is_zero(e - 1):
        return arb(0), False
    half = -e.log() / 2
    if half < 1:
        guess = 1.5707963 * (1 - float(half.mid())) ** 0.5
        phi = _root(lambda x: x * x.cos() / x.sin(), half, guess)
        return phi.cos(), False
    if half > 1:
        y = _root(lambda x: -x * x.cosh() / x.sinh(), -half, max(float(half.mid()), 0.1))
        return y.cosh(), False
    raise NotProvableError(said("whether a contact swings or creeps"))


def _root(falling: Callable[[Ball], Ball], value: Ball, guess: float) -> Ball:
    """x with falling(x) = value, enclosed."""
    x = arb(guess)
    step = arb(2) ** (-ctx.prec // 3)
    for _ in range(60):
        slope = (falling(x + step) - falling(x - step)) / (2 * step)
        change = ((falling(x) - value) / slope).mid()
        x = abs((x - change).mid())
        if abs(change) < x * arb(2) ** (GUARD // 2 - ctx.prec // 2):
            break
    width = x * arb(2) ** (GUARD - 7 * ctx.prec // 8) + value.rad() * 4
    low, high = (x - width).mid(), (x + width).mid()
    if falling(low) > value and falling(high) < value:
        return low.union(high)
    raise NotProvableError(said("the damping of a contact"))
