"""A row of carts integrated with forty digits and more: the oracle of certificates.

Every force is linear in overlaps and rates, so the motion of all bodies together is a power series;
it is summed step by step, and what ends a formula is found on the polynomials: sign changes on a
grid, then halving. No closed form, no ball, nothing of `sim`: only the definitions.
The inputs are the doubles of a scene: masses, velocities, gaps as the scene has them.
"""

from __future__ import annotations

from typing import Any

from mpmath import mp, mpf

from sim.scene import Scene
from tests.reference.digit_pairs import UnsupportedError
from tests.reference.digit_releases import exploders, latch, let_go
from tests.reference.digit_roots import ONE, first_negative
from tests.reference.digit_row import NOTHING
from tests.reference.digit_series import Motions, digits, fixed, value

DIGITS = 70
MOST_STEPS = 5000
"""A few seconds. What takes longer is left to other tests."""


class Digits(Motions):
    """One integration."""

    def go(self) -> None:
        end = mpf(self.scene.until)
        self.waiting = exploders(self)
        latch(self, self.waiting)
        self._let_go()
        self.judge(tell=False)
        for _ in range(MOST_STEPS):
            if self.t >= end:
                return
            self.series()
            if self.springs and end > MOST_STEPS * self.h:
                break
            goal = self._goal(end)
            step, what = min(fixed((goal - self.t) / self.h), ONE), None
            reached = step < ONE or self.t + self.h >= goal
            for coefficients, action in self.watches():
                root = first_negative(coefficients, step)
                if root is not None and (what is None or root < step):
                    step, what = root, action
            for j, g in enumerate(self.groups):
                way = digits(value(self.sx[j], step))
                for k in g.carts:
                    self.moved[k] += way
                g.v = digits(value(self.sv[j], step)) / self.h
            if what is not None:
                self.t += digits(step) * self.h
                self.change(*what)
            elif reached:
                self.t = goal
                self._let_go()
                self.judge()
            else:
                self.t += self.h
        raise UnsupportedError("too many steps")

    def _goal(self, end: mpf) -> mpf:
        """s. Up to where no push begins or ends."""
        times = [at for _, begin, stop, _ in self.pushes for at in (begin, stop)]
        times += [one.at for one in self.waiting]
        return min([end, *(at for at in times if at > self.t)])

    def _let_go(self) -> None:
        while self.waiting and self.waiting[0].at <= self.t:
            let_go(self, self.waiting.pop(0))

    def change(self, state: str, k: Any) -> None:
        if state == "halt":
            k.v = mpf(0)
        elif state == "slip":
            k.v = mpf(0)
            self.slipping[id(k)] = self.t
        elif state == "hit":
            self.hit(k)
        elif state == "fall":
            del self.loose[k], self.springs[k]
            self.tell("separate", self.scene.names_at(k))
        else:
            self._pair_changes(state, k)
        self.judge()

    def _pair_changes(self, state: str, k: int) -> None:
        pair = self.pairs[k]
        assert pair is not None
        names = self.scene.names_at(k)
        d, _ = self.overlap(k)
        if state == "touch":
            pair.state = "press" if pair.law == "bumper" else "on"
            self.tell("contact", names)
        elif state == "turn":
            pair.memory = d
            pair.state = "spring"
            if pair.e == 0:
                pair.state = "open"
                self.tell("separate", names)
                left, right = self.group(k - 1), self.group(k)
                if left and right and not left.fixed and not right.fixed:
                    left.v = right.v = (left.v + right.v) / 2  # differ by rounding only
        elif state == "open":
            if abs(self.overlap(k)[1]) <= NOTHING * 10**9:
                raise UnsupportedError("a contact that fades and never ends")
            lingers = pair.law.startswith("push") and d > NOTHING
            pair.state = "idle" if lingers else "open"
            self.tell("separate", names)
        elif state == "clear":
            pair.state, pair.memory = "open", mpf(0)
        elif state == "again" and pair.e > 0:
            pair.state = "spring" if pair.law == "bumper" else "on"
            self.tell("contact", names)
        elif state == "climb":
            pair.state = "press"
        else:
            raise UnsupportedError(f"{state} of {names}")

    def hit(self, k: int) -> None:
        contact, s = self.scene.contacts[k], self.overlap(k)[1]
        self.tell("contact", self.scene.names_at(k))
        left, right = self.group(k - 1), self.group(k)
        light = self._inverse(k - 1) + self._inverse(k)
        e = mpf(0) if contact.joins else mpf(contact.restitution)
        impulse = (1 + e) * s / light
        for g, way, cart in ((left, -1, k - 1), (right, 1, k)):
            if g is not None:
                g.v += way * impulse * self._inverse(cart)
                g.held = g.held  # judged next
        if contact.joins:
            self.joined.add(k)
            one = left or right
            assert one is not None
            if left and right:
                self.groups.remove(right)
                left.carts += right.carts
                left.fixed = left.fixed or right.fixed
            else:
                one.fixed = True
            if one.fixed:
                one.v = mpf(0)
            self.dampers()


def integrate(scene: Scene) -> Digits:
    """The end of a scene, its events, with some forty digits."""
    with mp.workdps(DIGITS):
        run = Digits(scene)
        run.go()
        return run
