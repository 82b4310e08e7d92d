"""The model laid over the readings: curves, residuals, and a model set by hand.

By hand a reader sets when the touch is (the time shift), velocities, mass ratio, e and how long the
contact lasts. Where the carts are is not a question to the eye: both places are chosen so that the
mean of each cart's residuals before the touch is zero. Standard library only.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from sim.measured.model.contact import Law
from sim.measured.model.motion import Motion, Parameters
from sim.measured.tracks import Measured

GRID = 160
"""Points of a curve outside of the contact."""

DENSE = 40
"""Points inside of it."""

USUAL_E, USUAL_RATIO, USUAL_CONTACT = 0.5, 1.0, 0.1
"""Where a reader starts: no answer is given away."""


@dataclass(frozen=True, slots=True)
class Overlay:
    """`curve`: times in s and places of both carts in m; `residuals`: measured minus model, m."""

    parameters: Parameters
    duration: float
    t: tuple[float, ...]
    x: tuple[tuple[float, ...], tuple[float, ...]]
    residuals: tuple[tuple[float, ...], tuple[float, ...]]

    @property
    def spread(self) -> float:
        """m. Root mean square of all residuals."""
        both = [*self.residuals[0], *self.residuals[1]]
        return math.sqrt(sum(r * r for r in both) / len(both))


def frequency(law: Law, e: float, duration: float) -> float:
    """1/s. sqrt(k/mu) of a contact that lasts so long [s]."""
    if law == "bumper":
        return 0.5 * math.pi * (1.0 + e) / duration
    return math.hypot(math.pi, math.log(max(e, 1e-6))) / duration


def overlay(measured: Measured, parameters: Parameters, law: Law) -> Overlay:
    """The model beside the readings."""
    motion = Motion(parameters, law)
    begin = min(track.t[0] for track in measured.tracks)
    end = max(track.t[-1] for track in measured.tracks)
    times = {begin + k * (end - begin) / GRID for k in range(GRID + 1)}
    times |= {parameters.touch + k * motion.duration / DENSE for k in range(DENSE + 1)
              if math.isfinite(motion.duration)}  # fmt: skip
    t = tuple(sorted(time for time in times if begin <= time <= end))
    states = [motion.state(time)[0] for time in t]
    return Overlay(
        parameters,
        motion.duration,
        t,
        (tuple(x for x, _ in states), tuple(x for _, x in states)),
        (_residuals(measured, motion, 0), _residuals(measured, motion, 1)),
    )


def _residuals(measured: Measured, motion: Motion, cart: int) -> tuple[float, ...]:
    track = measured.tracks[cart]
    return tuple(x - motion.state(t)[0][cart] for t, x in zip(track.t, track.value, strict=True))


def by_hand(measured: Measured, parameters: Parameters, law: Law) -> Overlay:
    """The same with both places moved: the mean residual of each cart before the touch is zero."""
    made = overlay(measured, parameters, law)
    means = []
    for track, residuals in zip(measured.tracks, made.residuals, strict=True):
        before = [r for t, r in zip(track.t, residuals, strict=True) if t < parameters.touch]
        means.append(_mean(before or residuals))
    first, second = means
    moved = replace(
        parameters, x=parameters.x + first, distance=parameters.distance + second - first
    )
    return overlay(measured, moved, law)


def first_try(measured: Measured, law: Law) -> Parameters:
    """Where a reader starts by hand: velocities of the first readings, and else nothing known."""
    first, second = measured.tracks
    beside = _nearest(second.t, second.value, first.t)
    distance, nearest = min(
        (x2 - x1, t) for t, x1, x2 in zip(first.t, first.value, beside, strict=True)
    )
    touch = nearest - 0.5 * USUAL_CONTACT
    v = (_slope(first.t, first.value, touch), _slope(second.t, second.value, touch))
    return Parameters(
        touch=touch,
        x=0.0,
        distance=distance,
        v=v,
        ratio=USUAL_RATIO,
        e=USUAL_E,
        w0=frequency(law, USUAL_E, USUAL_CONTACT),
    )


def _nearest(
    times: Sequence[float], values: Sequence[float], wanted: Sequence[float]
) -> list[float]:
    """The values that were read nearest to these times, which rise; in one passage."""
    found, k = [], 0
    for t in wanted:
        while k + 1 < len(times) and abs(times[k + 1] - t) < abs(times[k] - t):
            k += 1
        found.append(values[k])
    return found


def _slope(times: Sequence[float], values: Sequence[float], until: float) -> float:
    """m/s. The straight line through the readings before `until`, at least through three."""
    kept = max(3, sum(t < until for t in times))
    t, x = times[:kept], values[:kept]
    mean_t, mean_x = _mean(t), _mean(x)
    above = sum((a - mean_t) * (b - mean_x) for a, b in zip(t, x, strict=True))
    return above / sum((a - mean_t) ** 2 for a in t)


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)
