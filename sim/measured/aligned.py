"""Two devices with a clock each: their clocks are set by the contact itself.

Both see one push, with opposite signs and one shape. The shift between the clocks is where the
product of both readings, summed over all instants, has a peak; of several peaks (a hand pushed one
cart before) the one at which both have the same shape. A parabola through three steps refines it.
What is used up:
that both pushes act at the same time can no longer be tested; their sizes and shapes still can.
Standard library only.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from sim.measured.refusal import FitError
from sim.measured.track import Track
from sim.measured.tracks import Measured
from sim.scene.said import said

COARSE = 500
"""Steps that the longer recording is cut into for the first look."""

COMPARABLE, ACTIVE = 0.2, 0.1
"""Share of the highest peak from which others are judged; of the greatest reading: pushed."""

KEPT = 0.03
"""Share of the greatest product at which the push begins and ends."""

FEWEST = 8


def aligned(measured: Measured) -> tuple[Measured, float]:
    """The second track on the first one's clock, and by how many s it was moved."""
    first, second = measured.tracks
    step = max(one.t[-1] - one.t[0] for one in measured.tracks) / COARSE
    shift = _best(first, second, step, None)
    fine = max(_usual(first), _usual(second))
    if fine < step:
        shift = _best(first, second, fine, (shift - 2.0 * step, shift + 2.0 * step))
    moved = replace(second, t=tuple(t - shift for t in second.t))
    begin, end = max(first.t[0], moved.t[0]), min(first.t[-1], moved.t[-1])
    if end - begin < FEWEST * fine:
        reason = said("no push is found that both devices saw")
        raise FitError(reason, said("both on during the contact"), "no-contact")
    return replace(measured, tracks=(first, moved)), shift


def _usual(track: Track) -> float:
    gaps = sorted(b - a for a, b in zip(track.t[:-1], track.t[1:], strict=True))
    return gaps[len(gaps) // 2]


def _best(first: Track, second: Track, step: float, between: tuple[float, float] | None) -> float:
    """s. How much later the second clock shows the push."""
    a, b = _cells(first, step), _cells(second, step)
    offset = second.t[0] - first.t[0]
    low, high = -(len(a) - FEWEST), len(b) - FEWEST
    if between:
        low = max(low, round((between[0] - offset) / step))
        high = min(high, round((between[1] - offset) / step))
    if high < low:
        return between[0] if between else 0.0

    def fits(shift: int) -> float:
        begin, end = max(0, -shift), min(len(a), len(b) - shift)
        return abs(sum(a[k] * b[k + shift] for k in range(begin, end)))

    sums = {shift: fits(shift) for shift in range(low, high + 1)}
    best = max(sums, key=lambda shift: sums[shift])
    peaks = [
        shift
        for shift, value in sums.items()
        if value > COMPARABLE * sums[best]
        and value >= max(sums.get(shift - 1, 0.0), sums.get(shift + 1, 0.0))
    ]
    best = max(peaks, key=lambda shift: _like(a, b, shift), default=best)
    left, middle, right = (sums.get(best + k, 0.0) for k in (-1, 0, 1))
    bend = left - 2.0 * middle + right
    part = 0.5 * (left - right) / bend if bend < 0.0 else 0.0
    return (best + part) * step + offset


def _like(a: Sequence[float], b: Sequence[float], shift: int) -> float:
    """How much alike both are where the second is pushed: 1 for one shape."""
    top = max(map(abs, b))
    active = [k for k, value in enumerate(b) if abs(value) > ACTIVE * top]
    pairs = [(a[k - shift] if 0 <= k - shift < len(a) else 0.0, b[k])
             for k in range(max(0, active[0] - 2), min(len(b), active[-1] + 3))]  # fmt: skip
    ab, aa, bb = (sum(u * v for u, v in listed) for listed in (
        pairs, [(x, x) for x, _ in pairs], [(y, y) for _, y in pairs]))  # fmt: skip
    return abs(ab) / (aa * bb) ** 0.5 if aa > 0.0 and bb > 0.0 else 0.0


def _cells(track: Track, step: float) -> list[float]:
    """Means over cells of one width, their median taken off; an empty cell reads as quiet."""
    count = int((track.t[-1] - track.t[0]) / step) + 1
    sums, counts = [0.0] * count, [0] * count
    for t, value in zip(track.t, track.value, strict=True):
        k = min(int((t - track.t[0]) / step), count - 1)
        sums[k] += value
        counts[k] += 1
    middle = sorted(track.value)[len(track.value) // 2]
    return [s / n - middle if n else 0.0 for s, n in zip(sums, counts, strict=True)]


def push(a: Sequence[float], b: Sequence[float]) -> tuple[int, int]:
    """First and last index of the common push, widened by its own length on both sides."""
    product = [abs(x * y) for x, y in zip(a, b, strict=True)]
    wide = max(1, len(product) // 200)
    smooth = [sum(product[max(0, k - wide) : k + wide + 1]) for k in range(len(product))]
    top = max(range(len(smooth)), key=lambda k: smooth[k])
    low = high = top
    while low > 0 and smooth[low] > KEPT * smooth[top]:
        low -= 1
    while high < len(smooth) - 1 and smooth[high] > KEPT * smooth[top]:
        high += 1
    more = high - low
    return max(0, low - more), min(len(smooth) - 1, high + more)
