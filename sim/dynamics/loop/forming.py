"""A run in progress: its state, and how rows of bodies are settled and formed anew."""

from __future__ import annotations

import math
from collections import defaultdict

from sim.dynamics.loop import still, synchronise, transitions
from sim.dynamics.loop.calendar import Calendar
from sim.dynamics.loop.predictions import Predictions
from sim.dynamics.loop.rooms import no_approach, resting
from sim.dynamics.loop.select_solver import select_solvers
from sim.dynamics.loop.strikes import Strikes
from sim.dynamics.result.ledger import Ledger
from sim.dynamics.result.record import Record
from sim.dynamics.state import flips
from sim.dynamics.state.body import Body, Gap
from sim.dynamics.state.chain import Chain
from sim.dynamics.state.clock import ZERO, Time, elapsed
from sim.dynamics.state.loads import Forces
from sim.scene.model import Scene


class RunState:
    """A run in progress: chain, calendar, accounts; rows of bodies are settled and formed anew."""

    def __init__(self, scene: Scene, record: Record) -> None:
        self.scene, self.record = scene, record
        self.forces = Forces(scene) if scene.effects else None
        self.chain = Chain(scene, self.forces)
        self.calendar = Calendar(len(self.chain.gaps))
        self.ledger = Ledger(scene)
        self.solvers: defaultdict[str, int] = defaultdict(int)
        self.end: Time = (scene.until, 0.0)
        self.predictions = Predictions(self.chain, self.calendar, self.end)
        self.least = transitions.NOTHING * self.chain.length / scene.until  # m/s
        self.begun = max(abs(cart.velocity) for cart in scene.carts)  # m/s
        self.instant = flips.AT_ONE_INSTANT * scene.until
        self.strikes = Strikes(self.chain, record, self.ledger, self.instant, self.solvers)
        self.happened = self.steps = 0

    def settle(self, bodies: list[Body], now: Time) -> tuple[list[Body], list[Gap]]:
        """Settle the components of these bodies; the free gaps around them are brought to `now`."""
        return synchronise.components(self.chain, bodies, now, self.record, self.ledger)

    def settle_touched(
        self, bodies: list[Body], touched: list[Gap], now: Time
    ) -> tuple[list[Body], list[Gap]]:
        """As `settle`; the gaps that touch at this instant are among those returned."""
        for gap in touched:
            if now != ZERO and not transitions.is_push(gap):
                gap.room = -resting(gap)  # rounding of the search left: that is what a touch is
        flew = [gap.left.motion is None and gap.right.motion is None for gap in touched]
        settled, gaps = self.settle(bodies, now)
        for gap, free in zip(touched, flew, strict=True):
            if gap.left.mass < math.inf or gap.right.mass < math.inf:
                gap.rate = gap.right.v - gap.left.v
                # Of two that fly freely nothing has rounded it: a contact without an approach,
                # and without a force, would end at once and be found again.
                if no_approach(gap, now) and not (free and gap.law is not None):
                    gap.rate = 0.0
            self.strikes.see(gap)
        return settled, [*gaps, *touched]

    def form_again(
        self, bodies: list[Body], gaps: list[Gap], now: Time, *, begins: bool = False
    ) -> None:
        """What still belongs together gets new solvers; everything around is predicted anew.

        `begins`: what acts from the start; whom it moves or holds has not started or stopped.
        """
        bodies = sorted(bodies, key=lambda body: body.carts)
        if any(body.v != body.v for body in bodies):
            raise OverflowError("a velocity is not a number")  # the rest of the run would be none
        ready = elapsed(now, self.end) > 0.0
        held = [body.held for body in bodies]
        for body in bodies:
            self.calendar.void(body)
        nothing = min(self.least, transitions.NOTHING * max(self.begun, self.strikes.fastest))
        for solver in select_solvers(
            bodies, gaps, now, self.end, self.forces, self.record, nothing
        ):
            self.solvers[solver.name] += 1
            if solver.tier > 1:
                self.steps += 1
            if solver.members and not ready:  # an end foreseen for what moved it before is void too
                self.calendar.unforeseen(solver.members[0])
            elif solver.members:
                self.calendar.gap(solver.members[0], now, solver.duration)
            elif ready:
                self.calendar.body(solver.bodies[0], now, solver.duration)
        if self.forces is not None:
            still.begin(bodies, now, self.forces)
        for body, before in zip(bodies, held, strict=True):
            if body.held != before and not begins:
                self.record.moment("stop" if body.held else "start", body, now)
                self.happened += 1
        self.predictions.members(bodies, gaps, now)
