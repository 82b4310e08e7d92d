"""What two phones on two carts say, and what setting their clocks has used up."""

from __future__ import annotations

from sim.measured.third_law import SensorComparison
from sim.measured.words.fit import SYNTHETIC, places_for, with_half
from sim.scene.notation import number
from sim.scene.said import said


def of_phones(
    pair: SensorComparison, names: tuple[str, str], *, synthetic: bool = False
) -> list[str]:
    """Accelerations of the common push; their ratio is that of the masses the other way round."""
    a, b = names
    sure = 2.0 * max(pair.impulse_sd)
    places = places_for(sure)
    found: list[str] = [
        said(
            "Greatest acceleration of {a}: {first} m/s²; of {b}: {second} m/s².",
            a=a,
            b=b,
            first=number(pair.peaks[0], 2),
            second=number(pair.peaks[1], 2),
        ),
        said(
            "Velocity changes by {first} m/s for {a}, by {second} m/s for {b} (each ± {half}).",
            a=a,
            b=b,
            first=number(pair.impulses[0], places),
            second=number(pair.impulses[1], places),
            half=number(sure, places),
        ),
        said(
            "Acceleration of {b} ÷ acceleration of {a}: {ratio}. If both forces are equal in size, "
            "this is the mass of {a} ÷ the mass of {b}: weigh both (each with its phone).",
            a=a,
            b=b,
            ratio=with_half(pair.ratio, pair.ratio_half, ""),
        ),
    ]
    if pair.turned:
        found.append(
            said("Both phones count the push as positive: the sign of {cart} is turned.", cart=b)
        )
    if synthetic:
        found.append(SYNTHETIC)
    return found


def of_clocks(moved: float) -> str:
    """What setting the clocks by the contact has used up."""
    return said(
        "The second clock is set by the contact itself (it shows the push {time} s later). So "
        "these readings do not test that both pushes act at the same time; they test their sizes "
        "and their shapes.",
        time=number(moved, 3),
    )
