"""Modes that alternate without motion: what rounding cannot decide is decided by staying.

A contact is on or off, a bumper is pressed in or springs back, a cart slides or is held. The mode
changes where a quantity (a force, an overlap, a rate) passes through nought. Every law here is
continuous there, or its jump points back into the mode that holds (Filippov's sticking case): on
the very edge both modes give the same motion to first order, so that either may hold, and only what
is left of the quantity by rounding says otherwise. Taken at its word it makes the two alternate for
ever at one instant.

So a mode that was just left and is taken again, twice without motion, stays until its quantity has
passed through nought by more than rounding. Should that be too little, the margin grows fourfold
with every further alternation: after a dozen of them it is a ten-millionth of the quantity's own
size, and the run has moved on. Where all that is left of a motion is rounding, as for two that a
damped spring leaves just touching their walls, it moves on by no more than the margin and goes
back: what the margin lets pass is no motion yet, and the time that counts as one instant grows with
it. No other event is touched.

Impacts without a duration that come in turn at one time open and close the gaps between them, too,
dozens of times before a collapse (`collapse`). None of that is an alternation of rounding: each of
them leaves other velocities, and they end by themselves. As long as an approach is more than
rounding, a time at which several come counts as one change; one that is more than what counts as
rest has moved its bodies, and what changed before, a moment earlier too, was no alternation: a
cart between a wall and a dead bumper makes dozens of rounds in one instant.

Theory: Filippov, Differential Equations with Discontinuous Righthand Sides (1988); Acary &
Brogliato, Numerical Methods for Nonsmooth Dynamical Systems (2008), on hysteresis at a switching
surface.
"""

from __future__ import annotations

from typing import Protocol

from sim.dynamics.state.clock import Time, elapsed

AT_ONE_INSTANT = 1e-11
"""Of the length of the run. Changes of one mode that follow each other as closely are counted."""

UNDECIDED = 2
"""Changes at one instant from which on a mode stays. Fewer are what one event may consist of."""

MARGIN = 1e-14
"""Of a quantity's size over a step: what rounding leaves of nought, with room to spare."""

GROWS = 4.0
MOST = 22
"""The margin is MARGIN × GROWS^n after n alternations: at most 0.2 of the quantity. Two or three
are enough but where dozens of contacts change at once; more than a dozen are needed only where
the quantity is itself a rounding of the places."""

SEVERAL = 5
"""Changes at one instant from which on that instant grows with the margin: AT_ONE_INSTANT ×
GROWS^(n − SEVERAL). So it stays longer than the way through the margin takes, which is some
MARGIN × GROWS^n of a swing, and a swing is shorter than a run."""

NO_MOTION = 1e-8
"""Of a step of the series. A change longer ago than that has been followed by motion."""


class Changing(Protocol):
    """A gap or a body: when its mode changed last, and how often at that instant.

    `alternates`: those of the changes that count for the margin; `alternates_before`: how many they
    were with the first change at the very time of the last one: an impact restores it.
    """

    changed: Time
    flips: int
    alternates: int
    alternates_before: int


def note(one: Changing, now: Time, instant: float) -> None:
    """Its mode changes. `instant` [s]: what is closer together happens at one instant, and after
    several changes also what is no further apart than their margin leaves it."""
    passing = instant * GROWS ** max(0, min(one.alternates, MOST) - SEVERAL)
    since = elapsed(one.changed, now)
    again = since <= passing
    one.flips = one.flips + 1 if again else 0
    one.alternates = one.alternates + 1 if again else 0
    if since != 0.0:
        one.alternates_before = one.alternates
    one.changed = now


def jump(one: Changing, now: Time, *, moves: bool) -> None:
    """An impact changes its velocity by more than rounding: see above.

    `moves`: by more than what counts as rest, so that nothing before it alternated by rounding.
    """
    if moves:
        one.alternates = one.alternates_before = 0
    elif elapsed(one.changed, now) == 0.0:
        one.alternates = one.alternates_before


def margin(one: Changing, now: Time, step: float) -> float:
    """Part of a quantity's size by which it has to pass through nought to count; 0: none."""
    if one.alternates < UNDECIDED or elapsed(one.changed, now) > NO_MOTION * step:
        return 0.0
    return float(MARGIN * GROWS ** min(one.alternates, MOST))
