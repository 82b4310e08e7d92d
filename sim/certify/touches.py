"""A touch of finite duration, stage by stage; an impact and a joint, which have no duration.

    bumper                  press   N = k o                       until o′ = 0 (e = 1: o = 0)
                            back    N = (k/e²)(o − (1 − e²) M)    until N = 0; M: greatest overlap
    paper                   on      N = k o + c o′                until o = 0
    push-only, -uncorrected on      N = k o + c o′                until N = 0

A bumper keeps M, and a push-only pair its overlap, until the two are clear of each other; what
meets again before has no bound here. Hertz's law has no closed form: it has no bound either.
"""

from __future__ import annotations

from collections.abc import Callable

from sim.certify import damping
from sim.certify.arithmetic import arb
from sim.certify.balls import ZERO, Ball, NoBoundError, NotProvableError, exact, is_zero
from sim.certify.bodies import Body, Gap
from sim.certify.instants import Instant
from sim.certify.oscillation import Line
from sim.certify.phases import ContactPhase
from sim.certify.roots import first_root
from sim.scene.said import said

Damped = Callable[[Ball], tuple[Ball, bool]]

BUMPER = "bumper"
DAMPED: dict[str, tuple[Damped, bool]] = {
    "paper": (damping.to_zero_overlap, False),
    "push-only": (damping.to_zero_force, True),
    "push-only-uncorrected": (damping.to_zero_overlap, True),
}
"""ζ from e, and whether the contact ends at no force."""


class Touch:
    """A contact in progress between the bodies of a gap."""

    def __init__(self, gap: Gap, now: Instant) -> None:
        contact = gap.contact
        law, restitution = contact.law, contact.restitution
        if contact.stiffness is None or restitution is None:
            raise NoBoundError(said("{what} has no bound yet", what=law))
        if law != BUMPER and law not in DAMPED:
            raise NoBoundError(said("{what} has no bound yet", what=law))
        self.gap, self.law, self.begun = gap, law, now
        self.k, self.e = exact(contact.stiffness), exact(restitution)
        self.fresh = is_zero(gap.room)
        self.peaks: list[tuple[Instant, Ball]] = []  # s, N
        self.stage = "on"
        self.at_no_force = False
        if law == BUMPER:
            self._bumper()
        else:
            self._damped()

    @property
    def elastic(self) -> bool:
        """Is e exactly 1?"""
        return is_zero(self.e - 1)

    @property
    def turns_alone(self) -> bool:
        """Is it a bumper pressed against a wall? Where it turns, its cart stops."""
        walls = self.gap.left.mass is None or self.gap.right.mass is None
        return walls and self.stage == "press" and not self.elastic

    def _bumper(self) -> None:
        closing = -self.gap.rate
        if self.fresh or closing > 0 or self.elastic:
            self.stage, self.line = "press", Line(self.k, ZERO, ZERO)
        elif is_zero(closing) or closing < 0:
            self._spring_back(-self.gap.room)
        else:
            raise NotProvableError(said("whether {pair} are pressed together", pair=self.gap.shown))

    def _spring_back(self, greatest: Ball) -> None:
        square = self.e * self.e
        if is_zero(square):
            raise NoBoundError(said("a bumper that does not spring back is pressed at the start"))
        self.stage = "back"
        self.gap.memory = greatest
        self.line = Line(self.k / square, ZERO, (1 - square) * greatest)

    def _damped(self) -> None:
        find, self.at_no_force = DAMPED[self.law]
        zeta, critical = find(self.e)
        one, other = self.gap.left.mass, self.gap.right.mass
        both = one if other is None else other if one is None else one * other / (one + other)
        self.zeta = zeta
        self.line = Line(self.k, 2 * zeta * (self.k * both).sqrt(), ZERO, critical)
        if self.at_no_force and not self.fresh:
            push = -self.k * self.gap.room - self.line.gamma * self.gap.rate
            if not push > 0:
                raise NotProvableError(
                    said("whether {pair} push each other at the start", pair=self.gap.shown)
                )

    def force(self) -> Ball:
        """N, at `since` of the gap."""
        gap, line = self.gap, self.line
        return line.kappa * (-gap.room - line.rest) - line.gamma * gap.rate

    def end(self, phase: ContactPhase, horizon: Ball) -> tuple[Ball, str] | None:
        """s after the phase began, and `apart` or `turn`; None where it outlasts `horizon`."""
        known = self._formula(phase) if phase.unloaded else None
        if known is not None:
            return known
        swing, line = phase.swing, self.line
        doubt = said("how the contact of {pair} ends", pair=self.gap.shown)
        if self.stage == "press" and not self.elastic:
            tau = first_root(lambda t: swing.at(t)[1], lambda t: swing.all(t)[2], horizon, doubt)
            return None if tau is None else (tau, "turn")
        if self.at_no_force:
            tau = first_root(
                lambda t: swing.force(t)[0], lambda t: swing.force(t)[1], horizon, doubt
            )
        else:
            tau = first_root(
                lambda t: swing.at(t)[0] - line.rest, lambda t: swing.at(t)[1], horizon, doubt
            )
        if self.stage == "back":
            self._never_climbs(phase, horizon if tau is None else tau)
        return None if tau is None else (tau, "apart")

    def _formula(self, phase: ContactPhase) -> tuple[Ball, str] | None:
        """From first touch, or from the turn, with no load."""
        swing, half = phase.swing, arb.pi() / 2
        if self.stage == "back":
            return (half / swing.w, "apart") if is_zero(swing.r0) else None
        if not (self.fresh and phase.begun is self.begun):
            return None
        if self.stage == "press":
            return (2 * half / swing.w, "apart") if self.elastic else (half / swing.w, "turn")
        if self.at_no_force and swing.turns:
            return 2 * self.zeta.acos() / swing.w, "apart"
        if self.at_no_force:
            return 2 * self.zeta.acosh() / swing.w, "apart"
        return (2 * half / swing.w, "apart") if swing.turns else None

    def _never_climbs(self, phase: ContactPhase, until: Ball) -> None:
        again = first_root(
            lambda t: -phase.swing.at(t)[1],
            lambda t: -phase.swing.all(t)[2],
            until,
            said("whether {pair} are pressed again", pair=self.gap.shown),
        )
        if again is not None:
            raise NotProvableError(
                said("{pair} are pressed again as their bumper springs back", pair=self.gap.shown)
            )

    def see_peak(self, phase: ContactPhase, tau: Ball, now: Instant, cause: str) -> None:
        """The greatest force of a phase that lasted `tau` s and ended at `now`."""
        swing = phase.swing
        if cause == "turn":
            self.peaks.append((now, swing.force(tau)[0]))
            return
        if self.stage == "back" and (self.peaks or is_zero(swing.r0)):
            if not self.peaks:
                self.peaks.append((phase.begun, swing.force(ZERO)[0]))
            return
        first, rate = swing.force(ZERO)
        if rate <= 0:
            self.peaks.append((phase.begun, first))
            return
        if self.fresh and phase.unloaded and self.elastic and self.law == BUMPER:
            when: Ball | None = tau / 2
        else:
            when = first_root(
                lambda t: swing.force(t)[1],
                lambda t: swing.line.kappa * swing.all(t)[2] + swing.line.gamma * swing.all(t)[3],
                tau,
                said("when the force between {pair} is greatest", pair=self.gap.shown),
            )
        at = (now, tau) if when is None else (phase.begun.after(when), when)
        self.peaks.append((at[0], swing.force(at[1])[0]))

    def peak(self) -> Instant | None:
        """When the force was greatest; None where it never pushed."""
        best: tuple[Instant, Ball] | None = None
        for when, force in self.peaks:
            if best is None or force > best[1]:
                best = (when, force)
            elif not force < best[1] and when is not best[0]:
                raise NotProvableError(
                    said("when the force between {pair} is greatest", pair=self.gap.shown)
                )
        return best[0] if best is not None and best[1] > 0 else None

    def turn(self) -> bool:
        """The greatest overlap is reached; does the bumper spring back?"""
        if is_zero(self.e):
            return False
        self._spring_back(-self.gap.room)
        return True

    def part(self, *, turned: bool) -> None:
        """The two go their ways: what the gap keeps of the contact."""
        gap = self.gap
        if self.law == BUMPER and not self.elastic:
            if turned:  # e = 0: equal velocities, and the whole overlap stays
                gap.memory, gap.rate = -gap.room, ZERO
            else:
                gap.room = -self.line.rest
        elif self.at_no_force and not is_zero(self.zeta):
            gap.tail, gap.spent = (self.line.kappa, self.line.gamma), True
        else:
            gap.room = ZERO


def impact(gap: Gap) -> None:
    """v′ = V + e (V − v), at once."""
    restitution = gap.contact.restitution
    e = exact(restitution or 0.0)
    left, right = gap.left, gap.right
    common = common_velocity(left, right)
    closing = -gap.rate
    for body in (left, right):
        if body.mass is not None:
            body.v = common if is_zero(e) else common + e * (common - body.v)
            body.held = False
    gap.room, gap.rate = ZERO, e * closing


def common_velocity(left: Body, right: Body) -> Ball:
    """m/s, of the common centre; a wall stands still."""
    if left.mass is None or right.mass is None:
        return ZERO
    return (left.mass * left.v + right.mass * right.v) / (left.mass + right.mass)
