"""Locating events: a step keeps its formulas and ends where one of them stops holding.

A guard is a number that is positive while a formula holds: the room of a gap, the force or the
rate of a contact, the velocity of a sliding cart, what static friction has in reserve. Where one
falls within a step (`falls`), the step is taken again up to there, and the formulas change.
"""

from __future__ import annotations

from sim.dynamics.stepping import held, spent
from sim.dynamics.stepping.field import Field
from sim.dynamics.stepping.impacts import Impacts
from sim.dynamics.stepping.pairs import Pair, PerCart

Key = tuple[str, int, int]
"""("gap", its number, which of its guards), ("loose", the gap, which spring), ("near", the
gap, 0) or ("body", its first cart, 0)."""

NEAR = "near"
"""Guards of pairs that turn round without touching."""

CLEAR = "clear"
"""Bumpers that were clear within a step, and overlap at both its ends: one ends where they are."""

MOST_CHANGES = 12
"""Within one step. Then the rest of it is taken without looking, as methods without events do."""


class Located:
    """Formulas of a field that hold just now, and what changes them."""

    def __init__(self, field: Field, impacts: Impacts, s: PerCart, v: PerCart) -> None:
        self.field, self.impacts = field, impacts
        self.begin(0.0, s, v)

    def begin(self, t: float, s: PerCart, v: PerCart) -> None:
        """Choose all formulas from the state."""
        field = self.field
        field.modes = {}
        for pair in field.pairs:
            if pair.force is not None:
                d, rate = field.overlap(pair, s, v)
                field.modes[pair.gap] = pair.force.begin(d, rate, field.memory[pair.gap])
        self._grip(t, s, v)

    def guards(self, t: float, s: PerCart, v: PerCart) -> dict[Key, float]:
        """Every guard by its key."""
        field = self.field
        found: dict[Key, float] = {}
        assert field.modes is not None
        if field.held:
            for gap, two in held.guards(field, t, s, v).items():
                found["gap", gap, 0], found["gap", gap, 1] = two
        for pair in field.pairs:
            gap = pair.gap
            if gap in field.joined:
                continue
            d, rate = field.overlap(pair, s, v)
            if pair.apart:
                found[NEAR, gap, 0] = rate
            for which, spring in enumerate(pair.loose):
                found["loose", gap, which] = spring.reach + d
            if pair.force is None:
                found["gap", gap, 0] = -d
                continue
            if gap in field.spent:
                found["gap", gap, 0], found["gap", gap, 1] = spent.reserves(field, pair, s, v)
                continue
            reserves = pair.force.holds(field.modes[gap], d, rate, field.memory[gap])
            for which, value in enumerate(reserves):
                found["gap", gap, which] = value
        if field.grips is not None:
            total = field.forces(t, s, v)[2]
            for body in field.bodies:
                side = field.sliding.get(body[0], 0)
                static = sum(field.grips[k][1] for k in body)
                if not static:
                    continue  # nothing rubs on it, and it neither stops nor starts
                reserve = static - abs(sum(total[k] for k in body))
                found["body", body[0], 0] = side * v[body[0]] if side else reserve
        return found

    def idle(self, pair: Pair) -> bool:
        """Does nothing push in its gap just now?"""
        assert self.field.modes is not None
        return self.field.modes.get(pair.gap, "apart") == "apart"

    def change(self, keys: list[Key], t: float, s: PerCart, v: PerCart) -> None:
        """The formulas of these guards have come to their end; `v` is changed in place."""
        field = self.field
        assert field.modes is not None
        slipping, hit = [], []
        for kind, number, which in keys:
            if kind == NEAR:
                continue  # a step ends here, and is told of
            if kind == CLEAR:
                self.impacts.remember(s, v)
            elif kind == "loose":
                self.impacts.fall_off(field.pair_at[number], s, v, now=True)
            elif kind == "gap" and number in field.held:
                held.let_go(field, number)
                field.modes[number] = "press" if which else "apart"
            elif kind == "gap" and number in field.spent:
                self._push_again(field.pair_at[number], s, v, pressed=which == 0)
            elif kind == "gap":
                pair = field.pair_at[number]
                d, rate = field.overlap(pair, s, v)
                if pair.force is not None:
                    mode, memory = field.modes[number], field.memory[number]
                    field.modes[number], field.memory[number] = pair.force.after(
                        mode, d, rate, memory
                    )
                    if mode == "press" and pair.force.locks:
                        held.one_velocity(field, pair, v)
                        if held.stays_pressed(field, pair, t, s, v):
                            held.hold(field, pair)
                else:
                    hit.append(pair)
            elif field.sliding.get(number, 0):
                for k in next(body for body in field.bodies if number in body):
                    v[k] = 0.0
            else:
                slipping.append(number)
        self.impacts.strike(sorted(hit, key=lambda pair: pair.gap), s, v)
        self._grip(t, s, v, slipping)

    def _push_again(self, pair: Pair, s: PerCart, v: PerCart, *, pressed: bool) -> None:
        """Bumpers that a release parted are pressed again, or their overlap is gone."""
        field, gap = self.field, pair.gap
        assert field.modes is not None and pair.force is not None
        self.impacts.spilled -= spent.end(field, pair, s, v, pressed=pressed)
        field.modes[gap] = "apart"
        if pressed:
            d, rate = field.overlap(pair, s, v)
            field.modes[gap], field.memory[gap] = pair.force.after(
                "apart", d, rate, field.memory[gap]
            )

    def _grip(self, t: float, s: PerCart, v: PerCart, slipping: list[int] | None = None) -> None:
        """Which bodies slide, in which direction, and which are held."""
        field = self.field
        if field.grips is None:
            return
        total = field.forces(t, s, v)[2]
        for body in field.bodies:
            force = sum(total[k] for k in body)
            static = sum(field.grips[k][1] for k in body)
            if v[body[0]] != 0.0 or not static:
                side = 1 if v[body[0]] > 0.0 else -1
            elif abs(force) <= static and body[0] not in (slipping or []):
                side = 0
            else:
                side = 1 if force > 0.0 else -1
            field.sliding[body[0]] = side
