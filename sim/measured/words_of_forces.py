"""What two force sensors say about the third law, and when they say nothing about it."""

from __future__ import annotations

import math

from sim.measured.third_law import Pair
from sim.measured.words import SYNTHETIC, places_for, with_half
from sim.scene.notation import number

SCATTERED = 0.1
"""Half of the ratio's interval from which on nothing can be said of a ratio of 1."""


def of_pair(pair: Pair, names: tuple[str, str], *, synthetic: bool = False) -> list[str]:
    """What two force sensors say about the third law; nothing, where they are `synthetic`."""
    a, b = names
    sure = 2.0 * max(pair.impulse_sd)
    places = places_for(sure)
    said = [
        f"Greatest force on {a} by {b}: {number(pair.peaks[0], 2)} N; on {b} by {a}: "
        f"{number(pair.peaks[1], 2)} N.",
        f"Impulse on {a}: {number(pair.impulses[0], places)} N s; on {b}: "
        f"{number(pair.impulses[1], places)} N s (each ± {number(sure, places)}).",
        f"The sum of both forces is farthest from zero at {number(pair.worst[0], 3)} s: "
        f"{number(pair.worst[1], 2)} N. Where nothing pushes, the noise of the sum is "
        f"{number(math.hypot(*pair.noise), 2)} N.",
        f"Size of the force on {b} ÷ size of the force on {a}: "
        f"{with_half(pair.ratio, pair.ratio_half, '')}.",
    ]
    time, most = pair.apart
    if pair.ratio_half > SCATTERED:
        said.append(
            "These readings scatter too much to compare the two forces. Push with both sensors "
            "against each other alone, and keep what else touches them away."
        )
    elif abs(most) > pair.explained:
        said.append(
            f"At {number(time, 3)} s the two sensors are {number(abs(most), 2)} N apart; noise, "
            f"clocks and scales explain {number(pair.explained, 2)} N. Something else pushed one "
            "of them then, or it was not at rest on its cart. Leave that time out, or repeat."
        )
    elif abs(pair.ratio - 1.0) <= pair.ratio_half:
        percent = max(0.1, 100.0 * (abs(pair.ratio - 1.0) + pair.ratio_half))
        said.append(
            "At every instant the two forces are equal in size and opposite, as far as these "
            f"sensors can tell (to about {number(percent, 1)} %). "
            + (
                SYNTHETIC
                if synthetic
                else "No model was used for this: it is read off the readings alone."
            )
        )
    else:
        percent = 100.0 * abs(pair.ratio - 1.0)
        said.append(
            f"The two sensors differ by {number(percent, 1)} %, more than their noise explains. "
            "Swap the sensors and repeat. If the difference stays with a sensor, it is the sensor."
        )
    said.append(f"Zeros taken off: {number(pair.zeros[0], 3)} N and {number(pair.zeros[1], 3)} N.")
    if pair.turned:
        said.append(
            f"Both sensors count a push as positive. The sign of {b} is turned, because + means to "
            "the right for both carts here."
        )
    step = (pair.t[-1] - pair.t[0]) / (len(pair.t) - 1)
    if abs(pair.lag) > 0.5 * step:
        first, late = (a, b) if pair.lag > 0.0 else (b, a)
        said.append(
            f"The readings of {late} come {number(1e3 * abs(pair.lag), 1)} ms later than those of "
            f"{first}. That is the clock of the sensors, not the carts."
        )
    return said
