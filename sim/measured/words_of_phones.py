"""What two phones on two carts say, and what setting their clocks has used up."""

from __future__ import annotations

from sim.measured.third_law import Pair
from sim.measured.words import SYNTHETIC, places_for, with_half
from sim.scene.notation import number


def of_phones(pair: Pair, names: tuple[str, str], *, synthetic: bool = False) -> list[str]:
    """Accelerations of the common push; their ratio is that of the masses the other way round."""
    a, b = names
    sure = 2.0 * max(pair.impulse_sd)
    places = places_for(sure)
    said = [
        f"Greatest acceleration of {a}: {number(pair.peaks[0], 2)} m/s²; of {b}: "
        f"{number(pair.peaks[1], 2)} m/s².",
        f"Velocity changes by {number(pair.impulses[0], places)} m/s for {a}, by "
        f"{number(pair.impulses[1], places)} m/s for {b} (each ± {number(sure, places)}).",
        f"Acceleration of {b} ÷ acceleration of {a}: {with_half(pair.ratio, pair.ratio_half, '')}. "
        f"If both forces are equal in size, this is the mass of {a} ÷ the mass of {b}: weigh both "
        "(each with its phone).",
    ]
    if pair.turned:
        said.append(f"Both phones count the push as positive: the sign of {b} is turned.")
    if synthetic:
        said.append(SYNTHETIC)
    return said


def of_clocks(moved: float) -> str:
    """What setting the clocks by the contact has used up."""
    return (
        f"The second clock is set by the contact itself (it shows the push {number(moved, 3)} s "
        "later). So these readings do not test that both pushes act at the same time; they test "
        "their sizes and their shapes."
    )
