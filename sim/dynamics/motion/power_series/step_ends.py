"""What ends a step first: the earliest fall of everything that is positive while the step holds."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sim.dynamics.motion.guards import guards_of, offs_of, passed, reserves
from sim.dynamics.motion.power_series.polynomial import Poly, first_fall, size, value_and_slope
from sim.dynamics.motion.power_series.step import Step
from sim.dynamics.state.body import Body, End
from sim.dynamics.state.flips import NO_MOTION, margin

NEGLIGIBLE = 1e-13
"""Of the largest force in the group. Far ahead of the push that runs through a touching chain the
forces are a rounding error of it and less, and their sign means nothing: such a contact is kept."""


ROUNDING = 1e-15
"""Of the greatest speed in the group. Two that were held part no faster by rounding."""

PARTED = [-1.0]
"""Of a locked contact that nobody presses any more: it is over."""


FINAL = ("touch", "clear", "off", "nearest")
"""Ends that no rounding takes back."""


def first_ends(step: Step, sizes: list[float], clock: int | None = None) -> tuple[list[End], float]:
    """All that happens at one time, and that time [s]; nothing, and the span of the step.

    `sizes` [N] bound the contact forces in the step; inf: every force counts. What ends the gap
    that keeps the clock is looked for first: behind it the series mean nothing.
    """
    noise = NEGLIGIBLE * max((s for s in sizes if s < math.inf), default=0.0)
    ends: list[End] = []
    duration = step.span
    in_gaps = sorted(_in_gaps(step, sizes, noise), key=lambda one: one[0].k != clock)
    for end, guarded in [*in_gaps, *_of_bodies(step)]:
        found = first_fall(guarded, duration)
        stays = end.cause not in FINAL  # a contact that is taken up again stays on
        if found is not None and stays and found <= NO_MOTION * step.span:
            found = _when_decided(step, end, guarded, duration, found)
        if found is not None:
            if found < duration:
                ends.clear()
            ends.append(end)
            duration = found
    return ends, duration


NEARBY = 1e-3
"""Of a step. An end that is found again further off than that is another one."""


def found_again(step: Step, sizes: list[float], end: End, duration: float) -> float:
    """s. One step of Newton's method towards an end, on a step made anew up to about there."""
    for other, guarded in [*_in_gaps(step, sizes, 0.0), *_of_bodies(step)]:
        if other == end:
            here, growth = value_and_slope(guarded, duration)
            if growth < 0.0 and abs(here) <= NEARBY * duration * -growth:
                return duration - here / growth
    return duration


def _when_decided(
    step: Step, end: End, guarded: Poly, duration: float, found: float
) -> float | None:
    """When an end that comes without motion is to come, if it only takes back what just began."""
    if end.cause in ("halt", "slip"):
        body = step.bodies[end.k]
        part, least = margin(body, body.time, step.length), abs(body.v)
    else:
        gap = step.gaps[end.k]
        part, least = margin(gap, gap.time, step.length), _least(step, end)
    if part == 0.0:
        return found
    if guarded == PARTED:
        guarded = step.contact[end.k]
    room = part * (size(guarded, step.span) + least)
    return first_fall([guarded[0] + room, *guarded[1:]], duration)


def _least(step: Step, end: End) -> float:
    """What a speed that is known to rounding makes of the quantity that ends a mode of a gap."""
    k, branch = end.k, step.branches[end.k]
    speed = max(abs(step.speed[k][0]), abs(step.speed[k + 1][0]))
    if end.cause == "turn":
        return speed  # m/s
    law = step.gaps[k].law
    if law is not None and all(guard.of == "overlap" for guard in guards_of(step.gaps[k], branch)):
        return speed * step.length  # m
    return speed * (branch.kappa * step.length + branch.gamma)  # N


def _in_gaps(step: Step, sizes: list[float], noise: float) -> Iterator[tuple[End, Poly]]:
    still = ROUNDING * max(abs(speed[0]) for speed in step.speed)
    for k, (gap, branch) in enumerate(zip(step.gaps, step.branches, strict=True)):
        touches = gap.touching is not None
        if touches and branch.locked and (sizes[k] <= noise or gap.rate > still):
            yield End("apart", k), PARTED  # nobody pushes them together any more
            continue
        for guard in guards_of(gap, branch) if not touches or sizes[k] >= noise else offs_of(gap):
            quantity = step.along(k, guard)
            room = passed(guard) - guard.level
            if room and first_fall([quantity[0] + room, *quantity[1:]], step.span) is None:
                continue  # it comes just as deep as before
            if guard.cause == "turn" and gap.rate == 0.0:
                quantity = _without_noise(quantity, step.span)
            yield End(guard.cause, k), quantity


def _of_bodies(step: Step) -> Iterator[tuple[End, Poly]]:
    for i, body in enumerate(step.bodies):
        if body.carts and body.held:
            for direction, reserve in reserves(body, step.others(i)):
                yield End("slip", i, direction), reserve
        elif body.sliding and (body.load.static or body.load.quadratic):
            yield End("halt", i), _speed_onwards(body, step.speed[i], step.span)


ONSET = 1e-9
"""Of the speed in a step. At the onset of sliding, and where a bumper begins to be pressed further,
all forces balance: what is left of that acceleration, in time and force, has no sign."""


def _speed_onwards(body: Body, speed: Poly, length: float) -> Poly:
    """A body's speed in the direction in which it slides."""
    onwards = [body.sliding * c for c in speed]
    return _without_noise(onwards, length) if body.v == 0.0 else onwards


def _without_noise(rate: Poly, length: float) -> Poly:
    """A rate that begins at nought, and whose first growth is nothing but noise, without that."""
    if len(rate) > 1 and abs(rate[1]) * length <= ONSET * size(rate, length):
        return [rate[0], 0.0, *rate[2:]]
    return rate
