"""What two force sensors say about the third law, and when they say nothing about it."""

from __future__ import annotations

import math

from sim.measured.third_law import SCATTERED, SensorComparison
from sim.measured.words.fit import SYNTHETIC, places_for, with_half
from sim.scene.notation import number
from sim.scene.said import joined, said


def of_pair(
    pair: SensorComparison, names: tuple[str, str], *, synthetic: bool = False
) -> list[str]:
    """What two force sensors say about the third law; nothing, where they are `synthetic`."""
    found = [*_greatest(pair, names), _compared(pair, names, synthetic=synthetic)]
    zeros = [number(zero, 3) for zero in pair.zeros]
    found.append(
        said("Zeros taken off: {first} N and {second} N.", first=zeros[0], second=zeros[1])
    )
    if pair.turned:
        found.append(
            said(
                "Both sensors count a push as positive. The sign of {cart} is turned, because + "
                "means to the right for both carts here.",
                cart=names[1],
            )
        )
    if _late(pair):
        first, late = names if pair.lag > 0.0 else names[::-1]
        found.append(
            said(
                "The readings of {late} come {time} ms later than those of {first}. That is taken "
                "for the clocks of the sensors, and not for the carts.",
                late=late,
                time=number(1e3 * abs(pair.lag), 1),
                first=first,
            )
        )
    return found


def _greatest(pair: SensorComparison, names: tuple[str, str]) -> list[str]:
    """Forces, impulses, where their sum is farthest from zero, and the ratio of both."""
    a, b = names
    sure = 2.0 * max(pair.impulse_sd)
    places = places_for(sure)
    peaks, impulses = pair.peaks, pair.impulses
    return [
        said(
            "Greatest force on {a} by {b}: {first} N; on {b} by {a}: {second} N.",
            a=a,
            b=b,
            first=number(peaks[0], 2),
            second=number(peaks[1], 2),
        ),
        said(
            "Impulse on {a}: {first} N s; on {b}: {second} N s (each ± {half}).",
            a=a,
            b=b,
            first=number(impulses[0], places),
            second=number(impulses[1], places),
            half=number(sure, places),
        ),
        said(
            "The sum of both forces is farthest from zero at {time} s: {sum} N. Where nothing "
            "pushes, the noise of the sum is {noise} N.",
            time=number(pair.worst[0], 3),
            sum=number(pair.worst[1], 2),
            noise=number(math.hypot(*pair.noise), 2),
        ),
        said(
            "Size of the force on {b} ÷ size of the force on {a}: {ratio}.",
            a=a,
            b=b,
            ratio=with_half(pair.ratio, pair.ratio_half, ""),
        ),
    ]


def _late(pair: SensorComparison) -> bool:
    """Whether one sensor's readings come later than the other's."""
    return abs(pair.lag) > 0.5 * (pair.t[-1] - pair.t[0]) / (len(pair.t) - 1)


def _equal(pair: SensorComparison, names: tuple[str, str]) -> str:
    """At every instant, where no clock was moved to find it so."""
    percent = number(max(0.1, 100.0 * (abs(pair.ratio - 1.0) + pair.ratio_half)), 1)
    if pair.set is None and not _late(pair):
        return said(
            "At every instant the two forces are equal in size and opposite, as far as these "
            "sensors can tell (to about {percent} %).",
            percent=percent,
        )
    late = (pair.set or 0.0) + pair.lag
    return said(
        "Once the readings of {late} are moved to be {time} ms earlier, the two forces are equal "
        "in size and opposite at every instant, as far as these sensors can tell (to about "
        "{percent} %). Whether both act at the same time is then not tested by these readings.",
        late=names[1] if late > 0.0 else names[0],
        time=number(1e3 * abs(late), 1),
        percent=percent,
    )


def _compared(pair: SensorComparison, names: tuple[str, str], *, synthetic: bool) -> str:
    """Whether both forces are equal and opposite, as far as the sensors tell."""
    time, most = pair.apart
    off = abs(pair.ratio - 1.0)
    if pair.ratio_half > SCATTERED:
        return said(
            "These readings scatter too much to compare the two forces. Push with both sensors "
            "against each other alone, and keep what else touches them away."
        )
    if abs(most) > pair.explained:
        return said(
            "At {time} s the two sensors are {apart} N apart; noise, clocks and scales explain "
            "{explained} N. Something else pushed one of them then, or it was not at rest on its "
            "cart. Leave that time out, or repeat.",
            time=number(time, 3),
            apart=number(abs(most), 2),
            explained=number(pair.explained, 2),
        )
    if off <= pair.ratio_half:
        alone = said("No model was used for this: it is read off the readings alone.")
        return joined(_equal(pair, names), SYNTHETIC if synthetic else alone)
    return said(
        "The two sensors differ by {percent} %, more than their noise explains. Swap the sensors "
        "and repeat. If the difference stays with a sensor, it is the sensor.",
        percent=number(100.0 * off, 1),
    )
