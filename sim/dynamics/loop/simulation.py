"""What happens in a run, event by event: a touch, a separation, the end of a step, a push.

Each settles the components that it concerns, changes what it has to, lets them form anew and
predicts what comes next around them. Two bodies that fly freely and meet are the common case: they
have a shorter way.
"""

from __future__ import annotations

from collections.abc import Sequence

from sim.dynamics.loop import collapse, contacts, dead_rounds, impacts, release, transitions
from sim.dynamics.loop.first_struck import first_struck, is_alone
from sim.dynamics.loop.forming import RunState
from sim.dynamics.loop.rooms import resting
from sim.dynamics.motion.pair_contact import PairContact
from sim.dynamics.state import flips
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import place, velocity
from sim.dynamics.state.clock import ZERO, Time

MISSED = 5e-9
"""Of the longest cart. Touches are found to rounding; with so much room left the search gave up."""

A_SEARCH = 10
"""Steps of a power series, in time: so much a search costs that came to its last look. A cart of
1e-15 kg on a spring swings ten million times a second, and each swing is looked through."""


class Simulation(RunState):
    """The handlers of the events of a run."""

    def at_gap(self, gap: Gap, now: Time) -> None:
        """What was predicted for a gap happens."""
        if gap.solver is None:
            moving = gap.left.motion is not None or gap.right.motion is not None
            self.chain.advance(gap, now)
            missed = moving and gap.room + resting(gap) > MISSED * self.chain.length
            if missed and not transitions.is_push(gap):
                gap.rate = velocity(gap.right, now) - velocity(gap.left, now)
                self.predictions.gap(gap, now)  # the search came this far: they do not touch yet
                self.steps += A_SEARCH
                return
            self.begin(gap, now)
        elif isinstance(gap.solver, PairContact):
            self.separate(gap, gap.solver, now)
        else:
            self.motion_ends(_moved_in(gap), now)

    def begin(self, gap: Gap, now: Time) -> None:
        """Two bodies touch."""
        free = gap.left.motion is None and gap.right.motion is None
        if gap.law is None:
            if free and self.forces is None and self.strikes.is_plain(gap):
                self.predictions.bring_around(gap, now)
                if is_alone(self.chain, gap, now):
                    self.strike_alone(gap, now)
                    return
            self.strike_first(gap, now)
            return
        fastest = self.strikes.fastest
        if free and (run := dead_rounds.run_of(self.chain, gap, now, self.instant, fastest)):
            self.go_on_together(run, now)
            return
        self.happened += 2
        nothing = 0.0 < -gap.rate <= self.least
        if self.forces is not None or not free or not gap.law.linear or nothing:
            self.join([gap], now)
            return
        self.predictions.bring_around(gap, now)
        self.strikes.see(gap)
        flips.note(gap, now, self.instant)
        place(gap.left, now)
        place(gap.right, now)
        contacts.touch(gap, now, self.record, self.ledger)
        self.solvers["pair-contact"] += 1
        contact = gap.solver = contacts.pair_contact(gap, now)
        for body in (gap.left, gap.right):
            if body.carts:  # a wall can be in two contacts: it does not move in either
                body.motion = contact
                self.record.piece(body)
        self.calendar.gap(gap, now, contact.duration)
        for other in self.chain.neighbours(gap):
            if other is not None and other.solver is None:
                # Velocities do not jump at a touch, but a neighbour in a contact has moved on.
                if other.left.motion is not None and other.right.motion is not None:
                    other.rate = velocity(other.right, now) - velocity(other.left, now)
                self.predictions.gap(other, now)

    def go_on_together(self, run: list[Gap], now: Time) -> None:
        """What is left of the rounds of these gaps is rounding."""
        for gap in run:
            self.predictions.bring_around(gap, now)
        dead_rounds.together(run, now, self.ledger)
        for body in dict.fromkeys(body for gap in run for body in (gap.left, gap.right)):
            if body.carts:
                self.record.piece(body)
        for gap in run:
            self.predictions.gap(gap, now)
            self.predictions.around(gap, now)

    def strike_alone(self, gap: Gap, now: Time) -> None:
        """The common case of an impact: two that are free, and nobody else touches them."""
        self.happened += 1
        place(gap.left, now)
        place(gap.right, now)
        self.strikes.alone(gap, now)
        self.calendar.unforeseen(gap)
        self.predictions.around(gap, now)

    def strike_first(self, gap: Gap, now: Time) -> None:
        """An impact without duration is due; where several are, the fastest come first."""
        blocks = first_struck(self.chain, gap, now)
        struck = [one for block in blocks for one in block]
        if gap not in struck:
            self.calendar.gap(gap, now, 0.0)  # it waits for its turn
        if held := [one for one in struck if one.solver is not None]:
            free = [one for one in struck if one.solver is None]
            self.motion_ends(_moved_in(held[0]), now, beside=free)
            return
        for block in blocks:
            self.happened += len(block)
            if self.forces is None and _are_free(block):
                self.strike_free(block, now)
            else:
                self.join(block, now)

    def strike_free(self, block: list[Gap], now: Time) -> None:
        """An impact without duration between bodies that are free."""
        run = self.strikes.run_of(block, now)
        if run and not _are_free(run):
            self.join(block, now)
            return
        struck = run or block
        for one in struck:
            self.predictions.bring_around(one, now)
            place(one.left, now)
            place(one.right, now)
        self.strikes.at_once(block, now)
        if run:
            collapse.together(run, now, self.ledger)
            for body in dict.fromkeys(b for one in run for b in (one.left, one.right)):
                if body.carts:
                    self.record.piece(body)
        for one in struck:
            if one.joined:
                self.predictions.bring_around(one, now)
            self.predictions.gap(one, now)
            self.predictions.around(one, now)

    def separate(self, gap: Gap, contact: PairContact, now: Time) -> None:
        """The force of a contact that is alone has become zero."""
        self.happened += 1
        self.predictions.bring_around(gap, now)
        contacts.separate_pair(gap, contact, now, self.record, self.ledger)
        self.predictions.gap(gap, now, own_separation=True)
        self.predictions.around(gap, now)

    def join(self, touched: list[Gap], now: Time) -> None:
        """A touch of bodies that are not all free: everything that moves them forms anew."""
        pair = [body for gap in touched for body in (gap.left, gap.right)]
        motions = [body.motion for body in pair]
        in_contact = any(motion is not None and motion.tier > 0 for motion in motions)
        bodies, gaps = self.settle_touched(pair, touched, now)
        gap = touched[0]
        if gap.law is not None:
            flips.note(gap, now, self.instant)
            over = transitions.end_negligible_approach(gap, self.least, self.ledger)
            if not over or gap.flips >= flips.UNDECIDED:  # what presses it gives it more and more
                contacts.touch(gap, now, self.record, self.ledger)
        elif block := [one for one in touched if one.rate <= self.strikes.parts]:
            bodies = self.strike(block, bodies, gaps, now, in_contact=in_contact)
        self.form_again(bodies, gaps, now)

    def strike(
        self, block: list[Gap], bodies: list[Body], gaps: list[Gap], now: Time, *, in_contact: bool
    ) -> list[Body]:
        """An impact without duration among settled bodies; returns those that are left."""
        stay = self.strikes.stay(block, now, in_contact=in_contact)
        run = [] if stay else self.strikes.run_of(block, now)
        if run:
            more, between = self.settle([b for g in run for b in (g.left, g.right)], now)
            bodies = list(dict.fromkeys([*bodies, *more]))
            gaps += [g for g in dict.fromkeys([*between, *run]) if g not in gaps]
        self.strikes.at_once(block, now, stay)
        if run:
            collapse.together(run, now, self.ledger)
        for gap in stay:
            if not gap.joined:
                impacts.rest_together(self.chain, gap, self.ledger)
        for other in gaps:
            if other not in block and not other.joined:
                other.rate = other.right.v - other.left.v
                if other.law is None and other.rate != 0.0:
                    other.touching = None  # it rested; now it opens, or is struck in its turn
        return [body for body in bodies if self.chain.bodies[body.carts[0]] is body]

    def motion_ends(self, body: Body, now: Time, beside: Sequence[Gap] = ()) -> None:
        """A cluster's step or a flight is over, or something happened in it.

        `beside`: gaps that no springs hold, struck at this instant with those that they do.
        """
        motion = body.motion
        assert motion is not None
        near = [one for gap in beside for one in (gap.left, gap.right)]
        bodies, gaps = self.settle_touched([body, *near], list(beside), now)
        for gap in motion.members:
            gap.plain = 0 if motion.ends else gap.plain + 1
        self.happened += transitions.carry_out_ends(
            motion, now, self.record, self.ledger, self.instant, self.least
        )
        for block in transitions.struck(motion, beside, self.chain, self.ledger, now):
            self.happened += len(block)
            for gap in block:
                self.strikes.see(gap)
            bodies = self.strike(block, bodies, gaps, now, in_contact=True)
        self.form_again(bodies, gaps, now)

    def from_outside(self, number: int, now: Time) -> None:
        """A push begins or ends, or an exploder sets its energy free."""
        forces = self.forces
        assert forces is not None
        if number < len(forces.releases):
            one = forces.releases[number]
            gap = self.chain.gaps[one.gap]
            assert gap is not None
            bodies, gaps = self.settle([gap.left, gap.right], now)
            changed = release.set_free(self.chain, gap, one, now, self.record, self.ledger)
            self.happened += changed
            forces.used[one.kind] += changed
            bodies = [b for b in dict.fromkeys([*bodies, gap.left, gap.right]) if b.carts]
            self.form_again(bodies, [*gaps, gap], now, begins=now == ZERO)
            return
        forces.move_to(now[0])
        bodies, gaps = self.settle(list(dict.fromkeys(self.chain.bodies)), now)
        self.form_again(bodies, gaps, now)


def _moved_in(gap: Gap) -> Body:
    """One of the two whose motion the gap is a member of: no wall."""
    return gap.left if gap.left.carts else gap.right


def _are_free(gaps: list[Gap]) -> bool:
    """Do all bodies of these gaps fly freely?"""
    return all(gap.left.motion is None and gap.right.motion is None for gap in gaps)
