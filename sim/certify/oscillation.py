"""The overlap of two bodies whose forces are linear, under constant loads, in balls.

μ o″ = −κ (o − rest) − γ o′ + μ a        a: what the loads alone would do to o, m/s²
y = o − centre, centre = rest + μ a/κ    β = γ/(2μ), w0² = κ/μ
y  = e^(−βτ) (y0 C + (r0 + β y0) S)      C, S: cos wτ, sin wτ / w      w² = w0² − β² > 0
y′ = e^(−βτ) (r0 C − (β r0 + w0² y0) S)        1, τ                    w = 0, critical
                                               cosh wτ, sinh wτ / w    w² = β² − w0² > 0
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import ZERO, Ball, NotProvableError, is_zero
from sim.scene.said import said


@dataclass(frozen=True, slots=True)
class Line:
    """One linear branch of a contact law: N = κ (o − rest) + γ o′; `critical` where w is 0."""

    kappa: Ball  # N/m
    gamma: Ball  # N s/m
    rest: Ball  # m
    critical: bool = False  # for the two masses of the pair; not while friction holds one of them


def together(lines: Sequence[Line]) -> Line:
    """Those that act side by side as one; its rest is where their forces cancel."""
    if len(lines) == 1:
        return lines[0]
    kappa, gamma = (sum((getattr(one, key) for one in lines), ZERO) for key in ("kappa", "gamma"))
    return Line(kappa, gamma, sum((one.kappa * one.rest for one in lines), ZERO) / kappa)


class Oscillation:
    """The overlap from o0 [m] and its rate r0 [m/s] on."""

    def __init__(self, line: Line, mu: Ball, o0: Ball, r0: Ball, pull: Ball) -> None:
        self.line, self.mu, self.pull = line, mu, pull
        self.o0, self.r0 = o0, r0
        self.square = line.kappa / mu
        self.beta = line.gamma / (2 * mu)
        self.centre = line.rest if is_zero(pull) else line.rest + pull / self.square
        self.y0 = o0 - self.centre
        inside = self.square - self.beta * self.beta
        self.turns = not line.critical and bool(inside > 0)
        if line.critical:
            self.w = arb(0)
        elif self.turns or inside < 0:
            self.w = abs(inside).sqrt()
        else:
            raise NotProvableError(said("whether a contact swings or creeps"))

    def at(self, tau: Ball) -> tuple[Ball, Ball]:
        """o and o′."""
        beta = self.beta
        if self.line.critical:
            cos, sin = arb(1), tau
        elif self.turns:
            sin, cos = (self.w * tau).sin_cos()
            sin = sin / self.w
        else:
            sin, cos = (self.w * tau).sinh_cosh()
            sin = sin / self.w
        push = beta * self.r0 + self.square * self.y0
        y = self.y0 * cos + (self.r0 + beta * self.y0) * sin
        rate = self.r0 * cos - push * sin
        if is_zero(beta):
            return self.centre + y, rate
        fade = (-beta * tau).exp()
        return self.centre + fade * y, fade * rate

    def all(self, tau: Ball) -> tuple[Ball, Ball, Ball, Ball]:
        """o, o′, o″, o‴."""
        o, rate = self.at(tau)
        a = -2 * self.beta * rate - self.square * (o - self.centre)
        return o, rate, a, -2 * self.beta * a - self.square * rate

    def force(self, tau: Ball) -> tuple[Ball, Ball]:
        """N [N] and its rate."""
        o, rate, a, _ = self.all(tau)
        line = self.line
        return line.kappa * (o - line.rest) + line.gamma * rate, line.kappa * rate + line.gamma * a
