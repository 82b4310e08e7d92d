"""One contact of two carts alone, as fast as plain Python can: the judge runs hundreds of them.

Until they touch and after they have parted both fly: closed form. In between

    m_A a_A = −F_A(…)        m_B a_B = +F_B(…)

by the embedded pair of `sim.mine.embedded`, written out for two bodies; the end of the contact is
looked for on the cubic through overlap and rate at both ends of a step, and that step is taken
again up to there. It is the same motion as `sim.mine.follow` finds in the same scene: a test holds
the two together.
"""

from __future__ import annotations

from dataclasses import dataclass

from sim.mine.contact import WrittenForce
from sim.mine.embedded import DIFFERENCE, FIRST, QUICK, ROWS, SHORTEST, longer

Two = tuple[float, float]
State = tuple[float, float, float, float]
"""Ways since the touch [m] and velocities [m/s] of the left and the right cart."""

NEAR = 1e-12
"""Of a step. How well the end of a contact is searched for."""

TURNS = 60
"""Of that search."""


class NoEndError(ArithmeticError):
    """The steps became too short, or too many questions were asked."""


@dataclass(slots=True)
class Contact:
    """`until`: s that the run lasts; `rtol`: error of one step, of the closing speed."""

    force: WrittenForce
    masses: Two
    closing: float  # m/s
    until: float
    rtol: float
    most_calls: int

    def run(self, t: float, v: Two) -> tuple[float, State]:
        """From the touch at t to the end of the contact, or to `until`: when, and the state."""
        y: State = (0.0, 0.0, *v)
        a = self.accelerations(t, y)
        h = min(FIRST, self.until - t)
        law = self.force.law
        while t < self.until:
            h = min(h, self.until - t)
            after, b, error = self.step(t, h, y, a)
            factor = longer(error)
            if not error <= 1.0:
                h *= factor
                if h < SHORTEST * self.until or law.calls > self.most_calls:
                    raise self._no_end(y)
                continue
            self.force.look_at(after[0] - after[1], after[2] - after[3], self.closing)
            if after[0] - after[1] <= 0.0:
                part = self._end(y, after, h)
                return t + part, self.step(t, part, y, a)[0]
            t, y, a, h = t + h, after, b, h * factor
            if law.calls > self.most_calls:
                raise self._no_end(y)
        return self.until, y

    def _no_end(self, y: State) -> NoEndError:
        """Why there is none may be clear."""
        self.force.look_at(y[0] - y[1], y[2] - y[3], self.closing, stuck=True)
        return NoEndError()

    def _end(self, y: State, after: State, h: float) -> float:
        """s into the step at which the overlap is nought again."""
        d0, d1 = y[0] - y[1], after[0] - after[1]
        w0, w1 = h * (y[2] - y[3]), h * (after[2] - after[3])
        low, high = 0.0, 1.0
        for _ in range(TURNS):
            if high - low <= NEAR:
                break
            z = 0.5 * (low + high)
            rest = 1.0 - z
            d = rest * rest * ((1.0 + 2.0 * z) * d0 + z * w0) + z * z * (
                (3.0 - 2.0 * z) * d1 - rest * w1
            )
            low, high = (z, high) if d > 0.0 else (low, z)
        return high * h

    def accelerations(self, t: float, y: State) -> Two:
        """m/s² of the two."""
        force = self.force
        force.look(t, y[2], y[3])
        push = force.on("press", y[0] - y[1], y[2] - y[3], 0.0)
        return -(push + force.odd) / self.masses[0], (push - force.odd) / self.masses[1]

    def step(self, t: float, h: float, y: State, k1: Two) -> tuple[State, Two, float]:
        """The state h later, the accelerations there, and the error (1: just allowed)."""
        x, w, u, v = y
        a, b = k1
        f = self.accelerations
        z1 = h / 5
        u2, v2 = u + z1 * a, v + z1 * b
        c, d = f(t + z1, (x + z1 * u, w + z1 * v, u2, v2))
        z1, z2 = 3 * h / 40, 9 * h / 40
        u3, v3 = u + z1 * a + z2 * c, v + z1 * b + z2 * d
        e, g = f(t + 0.3 * h, (x + z1 * u + z2 * u2, w + z1 * v + z2 * v2, u3, v3))
        z1, z2, z3 = 44 * h / 45, -56 * h / 15, 32 * h / 9
        u4, v4 = u + z1 * a + z2 * c + z3 * e, v + z1 * b + z2 * d + z3 * g
        x4, w4 = x + z1 * u + z2 * u2 + z3 * u3, w + z1 * v + z2 * v2 + z3 * v3
        i, j = f(t + 0.8 * h, (x4, w4, u4, v4))
        z1, z2, z3, z4 = (n * h for n in ROW5)
        u5 = u + z1 * a + z2 * c + z3 * e + z4 * i
        v5 = v + z1 * b + z2 * d + z3 * g + z4 * j
        x5 = x + z1 * u + z2 * u2 + z3 * u3 + z4 * u4
        w5 = w + z1 * v + z2 * v2 + z3 * v3 + z4 * v4
        k, l = f(t + 8 * h / 9, (x5, w5, u5, v5))  # noqa: E741 - the letters of the stages
        z1, z2, z3, z4, z5 = (n * h for n in ROW6)
        u6 = u + z1 * a + z2 * c + z3 * e + z4 * i + z5 * k
        v6 = v + z1 * b + z2 * d + z3 * g + z4 * j + z5 * l
        x6 = x + z1 * u + z2 * u2 + z3 * u3 + z4 * u4 + z5 * u5
        w6 = w + z1 * v + z2 * v2 + z3 * v3 + z4 * v4 + z5 * v5
        m, n = f(t + h, (x6, w6, u6, v6))
        z1, z3, z4, z5, z6 = (q * h for q in ROW7)
        u7 = u + z1 * a + z3 * e + z4 * i + z5 * k + z6 * m
        v7 = v + z1 * b + z3 * g + z4 * j + z5 * l + z6 * n
        x7 = x + z1 * u + z3 * u3 + z4 * u4 + z5 * u5 + z6 * u6
        w7 = w + z1 * v + z3 * v3 + z4 * v4 + z5 * v5 + z6 * v6
        p, q = f(t + h, (x7, w7, u7, v7))
        z1, z3, z4, z5, z6, z7 = (r * h for r in ERROR)
        small = self.rtol * max(self.closing, abs(u - v), abs(u7 - v7))
        error = max(
            abs(z1 * a + z3 * e + z4 * i + z5 * k + z6 * m + z7 * p),
            abs(z1 * b + z3 * g + z4 * j + z5 * l + z6 * n + z7 * q),
            abs(z1 * u + z3 * u3 + z4 * u4 + z5 * u5 + z6 * u6 + z7 * u7) / QUICK,
            abs(z1 * v + z3 * v3 + z4 * v4 + z5 * v5 + z6 * v6 + z7 * v7) / QUICK,
        )
        return (x7, w7, u7, v7), (p, q), error / small


ROW5, ROW6 = ROWS[4], ROWS[5]
ROW7, ERROR = (tuple(c for c in row if c) for row in (ROWS[6], DIFFERENCE))
"""Of the embedded pair, without its noughts."""
