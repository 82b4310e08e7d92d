"""Two force sensors against each other: the third law measured, not assumed.

Each sensor sits on a cart and reads the force on that cart by the other one. From the readings:
the zero of each sensor, the sum of both at every instant, the impulse of each, and the ratio of
both as the slope of F_B against −F_A (both have noise: the line with the smallest distances at a
right angle). Standard library only.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass

from sim.measured.aligned import aligned, push
from sim.measured.impulses import QUIET, Z, impulse, impulse_sd, rounded, widths
from sim.measured.refusal import FitError
from sim.measured.rounding import EVEN, common_step
from sim.measured.tracks import Measured
from sim.scene.said import said

SURE = 6.0
"""Standard deviations that none of some thousand readings lies beyond by chance."""

SHAPE = 0.1
"""Share of the greatest force by which two sensors differ on a steep slope, law or no law."""

FEWEST = 8
"""Readings that both sensors have in common; fewer show no course of a push."""

SEEN = 5.0
"""Standard deviations of a sensor's noise that a push has to stand out by."""

LATEST = 20
"""Readings by which one clock is looked for behind the other at most, or a quarter of them all: a
pulse still lies within what is compared then."""

SCATTERED = 0.1
"""Half of the ratio's interval from which on nothing can be said of a ratio of 1."""

NEAR, MOST = 3.5, 0.9
"""Steps; share of the quiet readings that lie so near, where no noise is much larger than they."""

MIDDLE = 0.6745  # median of |x| with noise 1
STEP = 0.954  # median of |difference| of two readings with noise 1: 0.6745 √2


@dataclass(frozen=True, slots=True)
class SensorComparison:
    """What two sensors say. Forces in N, impulses in N s, A first."""

    t: tuple[float, ...]
    forces: tuple[tuple[float, ...], tuple[float, ...]]  # zeros taken off, opposite signs
    zeros: tuple[float, float]
    turned: bool  # both sensors count a push as positive: the sign of B is turned
    noise: tuple[float, float]  # standard deviation where nothing pushes
    peaks: tuple[float, float]
    impulses: tuple[float, float]
    impulse_sd: tuple[float, float]
    ratio: float  # |F_B| : |F_A|
    ratio_half: float  # half of its 95 % interval
    worst: tuple[float, float]  # t and sum where the sum is farthest from zero
    apart: tuple[float, float]  # t and how far F_B is from −ratio F_A, clocks set, where it is most
    explained: float  # N, how far noise and the shapes of two sensors bring them apart
    lag: float  # s, how much later B's readings are
    set: float | None = None  # s, by which B's clock was set by the contact


def third_law(measured: Measured) -> SensorComparison:
    """Both sensors compared; raises FitError if they saw no push.

    Two phones, and sensors whose clocks do not overlap, are set by the contact; of phones only the
    common push is compared, for hands push them too. So are two files that show one push at two
    times: each may count from its own start.
    """
    first, second = measured.tracks
    apart = second.t[0] > first.t[-1] or first.t[0] > second.t[-1]
    if apart or measured.kind == "acceleration":
        return _compared(*aligned(measured))
    if not measured.two_files:
        return _compared(measured)
    try:
        found = _compared(measured)
    except FitError as why:
        with suppress(FitError):
            return _compared(*aligned(measured))
        raise why from None
    if found.ratio_half > SCATTERED:
        with suppress(FitError):
            found = min(found, _compared(*aligned(measured)), key=lambda one: one.ratio_half)
    return found


def _compared(measured: Measured, moved: float | None = None) -> SensorComparison:
    first, second = measured.tracks
    phones = measured.kind == "acceleration"
    t = tuple(time for time in first.t if second.t[0] <= time <= second.t[-1])
    if len(t) < FEWEST:
        reason = said("the two sensors did not read at the same time")
        raise FitError(reason, said("one log with both"))
    raw = tuple(_at(first.t, first.value, t)), tuple(_at(second.t, second.value, t))
    steps = common_step(first.value), common_step(second.value)
    zeros = _zero(raw[0], steps[0]), _zero(raw[1], steps[1])
    a, b = ([value - zero for value in values] for values, zero in zip(raw, zeros, strict=True))
    if phones:
        low, high = push(a, b)
        low, high = (low, high) if high - low >= FEWEST else (0, len(t) - 1)
        t, a, b = t[low : high + 1], a[low : high + 1], b[low : high + 1]
    peaks = max(map(abs, a)), max(map(abs, b))
    noise = _noise(a, peaks[0], steps[0]), _noise(b, peaks[1], steps[1])
    for peak, sd, name in zip(peaks, noise, measured.names, strict=True):
        if peak <= SEEN * sd:
            raise FitError(
                said("the sensor of {cart} shows no push that is larger than its noise", cart=name),
                said("keep some tenths of a second before and after the contact"),
            )
    product = sum(x * y for x, y in zip(a, b, strict=True))
    turned = product > 0.0
    if turned:
        b = [-value for value in b]
    ratio, half = _slope(a, b)
    half = max(half, rounded(a, ratio, steps))
    sums = [x + y for x, y in zip(a, b, strict=True)]
    worst = max(range(len(t)), key=lambda k: abs(sums[k]))
    wide = widths(t)
    lag = _lag(t, a, b)
    spread = SURE * math.hypot(ratio * noise[0], noise[1])
    apart = _apart(t, a, b, ratio, lag)
    return SensorComparison(
        t=t,
        forces=(tuple(a), tuple(b)),
        zeros=zeros,
        turned=turned,
        noise=noise,
        peaks=peaks,
        impulses=(impulse(a, wide), impulse(b, wide)),
        impulse_sd=(
            impulse_sd(noise[0], wide, a, steps[0]),
            impulse_sd(noise[1], wide, b, steps[1]),
        ),
        ratio=ratio,
        ratio_half=half,
        worst=(t[worst], sums[worst]),
        apart=apart,
        explained=spread + SHAPE * peaks[1],
        lag=lag,
        set=moved,
    )


def _apart(
    t: Sequence[float], a: Sequence[float], b: Sequence[float], ratio: float, lag: float
) -> tuple[float, float]:
    """Where B, as late as its clock is and as large as its scale, leaves A the most: t and N."""
    moved = _at(t, b, [time + lag for time in t])
    pairs = [
        (time, y + ratio * x)
        for time, x, y in zip(t, a, moved, strict=True)
        if t[0] <= time + lag <= t[-1]
    ]
    return max(pairs, key=lambda pair: abs(pair[1]), default=(t[0], 0.0))


def _at(t: Sequence[float], values: Sequence[float], times: Sequence[float]) -> list[float]:
    """Readings at these times, which rise; straight lines between those at t."""
    found, k = [], 0
    for time in times:
        while k + 2 < len(t) and t[k + 1] < time:
            k += 1
        share = min(1.0, max(0.0, (time - t[k]) / (t[k + 1] - t[k])))
        found.append(values[k] + share * (values[k + 1] - values[k]))
    return found


def _zero(values: Sequence[float], step: float) -> float:
    """What the sensor reads when nothing pushes: most readings lie around it. Between two steps of
    one that rounds, their mean tells, and the middle one is half a step off."""
    middle = _median(values)
    reach = max(abs(value - middle) for value in values)
    quiet = [value for value in values if abs(value - middle) <= QUIET * reach]
    zero = _median(quiet)
    near = [value for value in quiet if abs(value - zero) < NEAR * step]
    return sum(near) / len(near) if len(near) > MOST * len(quiet) else zero


def _noise(values: Sequence[float], peak: float, step: float) -> float:
    """Standard deviation: of what is quiet, or by the steps from reading to reading if larger; not
    less than that of readings that are rounded to such a `step`."""
    quiet = _median([abs(value) for value in values if abs(value) <= QUIET * peak] or [0.0])
    steps = _median(abs(b - a) for a, b in itertools.pairwise(values))
    return max(quiet / MIDDLE, steps / STEP, EVEN * step)


def _median(values: Iterable[float]) -> float:
    """The middle one; the upper of two. (A page would load a module for it.)"""
    ordered = sorted(values)
    return ordered[len(ordered) // 2]


def _slope(a: Sequence[float], b: Sequence[float]) -> tuple[float, float]:
    """−F_B/F_A by distances at a right angle, and half of its 95 % interval."""
    n = len(a)
    ma, mb = sum(a) / n, sum(b) / n
    aa = sum((x - ma) ** 2 for x in a)
    bb = sum((y - mb) ** 2 for y in b)
    ab = -sum((x - ma) * (y - mb) for x, y in zip(a, b, strict=True))
    if ab <= 0.0:
        reason = said("the two sensors do not show the same push")
        raise FitError(reason, said("check that both were on"))
    slope = (bb - aa + math.hypot(bb - aa, 2.0 * ab)) / (2.0 * ab)
    r2 = min(1.0, ab * ab / (aa * bb))
    return slope, Z * slope * math.sqrt((1.0 - r2) / (r2 * (n - 2)))


def _lag(t: Sequence[float], a: Sequence[float], b: Sequence[float]) -> float:
    """s. The shift at which both fit best: a parabola through three whole steps."""
    step = (t[-1] - t[0]) / (len(t) - 1)
    most = min(LATEST, len(t) // 4)

    def fits(shift: int) -> float:
        low, high = max(0, -shift), min(len(a), len(a) - shift)
        return -sum(a[k] * b[k + shift] for k in range(low, high))

    best = max(range(-most, most + 1), key=fits)
    left, middle, right = fits(best - 1), fits(best), fits(best + 1)
    bend = left - 2.0 * middle + right
    part = 0.5 * (left - right) / bend if bend < 0.0 else 0.0
    return (best + part) * step
