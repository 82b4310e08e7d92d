"""A touch of finite duration, stage by stage.

    bumper                  press   N = k o                       until o′ = 0 (e = 1: o = 0)
                            back    N = (k/e²)(o − (1 − e²) M)    until N = 0; M: greatest overlap
    paper                   on      N = k o + c o′                until o = 0
    push-only, -uncorrected on      N = k o + c o′                until N = 0

A bumper keeps M, and a push-only pair its overlap, until the two are clear of each other. What
meets again before goes on where it was: a bumper back along its second line, and along the first
once it is pressed further than M. Hertz's N = k o^(3/2) has no Taylor series at the touch, so no
bound here.
"""

from __future__ import annotations

from collections.abc import Callable

from sim.certify import damping
from sim.certify.bodies import Gap
from sim.certify.impacts import reduced_mass
from sim.certify.instants import Instant
from sim.certify.numbers.arithmetic import arb
from sim.certify.numbers.balls import ZERO, Ball, NoBoundError, NotProvableError, exact, is_zero
from sim.certify.numbers.roots import first_root
from sim.certify.oscillation import Line
from sim.certify.phases import ContactPhase
from sim.certify.watches import Watch, signal
from sim.scene.laws import power_of
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
        bounded = law == BUMPER or law in DAMPED
        added = not bounded and power_of(law) == 1  # a linear one, by somebody
        if contact.stiffness is None or restitution is None or added:
            raise NoBoundError(said("{what} has no bound yet", what=law))
        if not bounded:
            raise NoBoundError(said("{what} has no bound: its force is not linear", what=law))
        self.gap, self.law, self.begun = gap, law, now
        self.k, self.e = exact(contact.stiffness), exact(restitution)
        self.fresh = is_zero(gap.room)
        self.peaks: list[tuple[Instant, Ball]] = []  # s, N
        self.stage = "on"
        self.at_no_force = False
        self.nought: Instant | None = None  # when its next end is exactly 0, as it begins
        self.greatest = ZERO  # m, the overlap at the turn
        self.turned = False
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

    @property
    def turns_at_rest(self) -> bool:
        """The same, where the neighbour may be a cart that friction holds."""
        still = self.gap.left.still or self.gap.right.still
        return still and self.stage == "press" and not self.elastic

    def _bumper(self) -> None:
        closing = -self.gap.rate
        if not is_zero(self.gap.memory):
            self._spring_back(self.gap.memory)
            self.nought = self.begun
        elif self.fresh or closing > 0 or self.elastic:
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
        self.greatest = self.gap.memory = greatest
        self.line = Line(self.k / square, ZERO, (1 - square) * greatest)

    def _damped(self) -> None:
        find, self.at_no_force = DAMPED[self.law]
        zeta, critical = find(self.e)
        mu = reduced_mass(self.gap.left, self.gap.right)
        self.zeta = zeta
        self.line = Line(self.k, 2 * zeta * (self.k * mu).sqrt(), ZERO, critical)
        if self.gap.tail is not None:  # its force rises from nought, or an impact brought it back
            self.gap.tail, self.nought = None, None if self.force() > 0 else self.begun
        elif not self.fresh:
            self.still_pushes(self.begun)

    def still_pushes(self, now: Instant) -> None:
        """Rates have been changed at once: the force must not pull, and a bumper may turn."""
        if self.stage == "press" and not self.elastic and not self.gap.rate > 0:
            return
        if self.stage == "press" and not self.elastic:
            self.peaks.append((now, self.force()))
            if not self.turn(now):
                raise NoBoundError(
                    said("{pair} stay pressed together under a force", pair=self.gap.shown)
                )
        elif self.at_no_force and not self.force() > 0:
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
            again = self._climbs(phase, horizon if tau is None else tau)
            if again is not None:
                return again, "climb"
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
        held = phase.left.held or phase.right.held
        if self.at_no_force and held and not is_zero(self.zeta):
            return None  # ζ is of both masses: beside one that is held the other's alone swings
        if self.at_no_force and swing.turns:
            return 2 * self.zeta.acos() / swing.w, "apart"
        if self.at_no_force:
            return 2 * self.zeta.acosh() / swing.w, "apart"
        return (2 * half / swing.w, "apart") if swing.turns else None

    def _climbs(self, phase: ContactPhase, until: Ball) -> Ball | None:
        """Is a bumper on its way back pressed beyond its greatest overlap?"""
        swing = phase.swing
        doubt = said("whether {pair} are pressed again", pair=self.gap.shown)
        if is_zero(swing.r0) or swing.r0 < 0:
            turned = first_root(lambda t: -swing.at(t)[1], lambda t: -swing.all(t)[2], until, doubt)
            if turned is None:
                return None
        if not self.greatest - swing.o0 > 0:
            raise NotProvableError(doubt)
        return first_root(
            lambda t: self.greatest - swing.at(t)[0], lambda t: -swing.at(t)[1], until, doubt
        )

    def watches(self, k: int, now: Instant) -> list[Watch]:
        """What ends the present stage in a longer row, where this is gap k, from `now` on."""
        one, none, line = arb(1), ZERO, self.line
        doubt = said("how the contact of {pair} ends", pair=self.gap.shown)
        exactly = self.nought is now
        if self.stage == "press" and not self.elastic:
            return [Watch(signal(k, (none, one, none)), "turn", doubt, self.gap)]
        factors = (one, none, -line.rest)
        if self.at_no_force:
            factors = (line.kappa, line.gamma, none)
        again = exactly and (self.at_no_force or self.begun is now)
        found = [Watch(signal(k, factors, nought=again), "apart", doubt, self.gap)]
        if self.stage == "back":
            doubt = said("whether {pair} are pressed again", pair=self.gap.shown)
            room = signal(k, (-one, none, self.greatest), nought=exactly and not again)
            found.append(Watch(room, "climb", doubt, self.gap))
        return found

    def turn(self, now: Instant) -> bool:
        """The greatest overlap is reached; does the bumper spring back?"""
        if is_zero(self.e):
            return False
        self._spring_back(-self.gap.room)
        self.nought, self.turned = now, True
        return True

    def climb(self) -> None:
        """It is pressed further than before: along the first line again."""
        self.stage, self.line, self.nought = "press", Line(self.k, ZERO, ZERO), None

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
