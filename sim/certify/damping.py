"""The damping ζ of a law from the restitution e that it returns, as a ball.

`paper`, and `push-only-uncorrected`, which is printed so: ζ = cos φ, φ = atan2(π, −ln e).
`push-only`: φ cot φ = −(ln e)/2, beyond critical damping y coth y = −(ln e)/2, ζ = cosh y. That
root is found by Newton's method and then proved: the function falls, and has its two signs at the
ends of a short interval. See `sim.laws.dashpot` for where the formulas come from; nothing of it is
used.
"""

from __future__ import annotations

from collections.abc import Callable

from flint import arb, ctx

from sim.certify.balls import Ball, NotProvableError, is_zero

GUARD = 24
"""Bits that Newton's method may lose: the interval is so much wider than the last place."""


def to_zero_overlap(e: Ball) -> tuple[Ball, bool]:
    """ζ of a contact that ends at overlap 0, and whether it is critical."""
    if is_zero(e):
        return arb(1), True
    if is_zero(e - 1):
        return arb(0), False
    return arb.atan2(arb.pi(), -e.log()).cos(), False


def to_zero_force(e: Ball) -> tuple[Ball, bool]:
    """ζ of a contact that ends at no force."""
    if is_zero(e - 1):
        return arb(0), False
    half = -e.log() / 2
    if half < 1:
        phi = _root(lambda x: x * x.cot(), half, 1.5707963 * (1 - float(half.mid())) ** 0.5)
        return phi.cos(), False
    if half > 1:
        y = _root(lambda x: -x * x.coth(), -half, max(float(half.mid()), 0.1))
        return y.cosh(), False
    raise NotProvableError("whether a contact swings or creeps")


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
    raise NotProvableError("the damping of a contact")
