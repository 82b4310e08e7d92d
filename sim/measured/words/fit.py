"""What a fit says, in short sentences, and what it cannot say."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from sim.measured.model.effects import ALIKE, Compared
from sim.measured.model.fit import Fit
from sim.measured.model.quantity import Known
from sim.measured.model.unknowns import RUBS
from sim.scene.notation import number
from sim.scene.said import counted, joined, said

LAWS = {
    "bumper": said("the bumper law: the force starts from zero and never pulls"),
    "paper": said("the paper's law: spring and damper, until the bumper is clear"),
}
FASTEST = 10.0
"""m/s. Carts in a school are slower."""

PROGRAM = said(
    "The mass ratio comes out of the third law, which this model has built in. Weigh both carts: "
    "if the ratio from the balance is the same, your carts have confirmed it."
)

SYNTHETIC = said("A program that was told the third law made these readings: no evidence for it.")


def places_for(half: float) -> int:
    """Decimals that show an uncertainty with two digits."""
    if not (math.isfinite(half) and half > 0.0):
        return 6
    return min(15, max(0, 1 - math.floor(math.log10(half))))


def with_half(value: float, half: float, unit: str) -> str:
    """0.801 ± 0.002 m/s."""
    places = places_for(half)
    return f"{number(value, places)} ± {number(half, places)}{f' {unit}' if unit else ''}"


def of_interval(one: Known) -> str:
    """The value with its interval."""
    places = places_for(one.half)
    low, high = number(one.low, places), number(one.high, places)
    if one.key == "e" and (one.high >= 1.0 or one.low <= 0.0):  # cut off at what is possible
        return said("from {low} to {high}", low=low, high=high)
    text = with_half(one.value, one.half, one.unit)
    if one.alone:
        half = 0.5 * (one.alone[1] - one.alone[0])
        alone = number(half, places_for(half))
        return said("{value} (the readings alone: ± {half})", value=text, half=alone)
    middle = 0.5 * (one.low + one.high)
    if abs(middle - one.value) > 0.1 * one.half:  # a lopsided interval is told by its ends
        return said("{value} (from {low} to {high})", value=text, low=low, high=high)
    return text


def of_law(*, synthetic: bool) -> str:
    """Where a ratio of masses comes from, and what would confirm it; `synthetic`: nothing can."""
    return SYNTHETIC if synthetic else PROGRAM


def of_fit(
    fit: Fit, names: tuple[str, str], compared: Sequence[Compared], *, synthetic: bool
) -> list[str]:
    """What a reader should know beside its numbers; `synthetic`: a program made the readings."""
    found = []
    e, half = fit.parameters.e, fit.factor * fit.sd("e")
    if e - half > 1.0:
        found.append(ABOVE_ONE)
    fastest = max(map(abs, fit.parameters.v))
    if fastest > FASTEST:
        found.append(
            said(
                "A cart moves with {speed} m/s here. Are lengths and times really in the units "
                "that stand above?",
                speed=number(fastest, 0),
            )
        )
    if fit.heavy:
        found.append(
            counted(
                "1 reading counts less than the others (Huber's loss beyond four standard "
                "deviations from the model).",
                "{n} readings count less than the others (Huber's loss beyond four standard "
                "deviations from the model).",
                n=fit.heavy,
            )
        )
    row = next((one for one in compared if one.effect == fit.asked.effect), None)
    if row and row.alike > ALIKE:
        found.append(NOT_RANDOM)
    if fit.asked.effect in RUBS:
        for name, rests in zip(names, fit.parameters.rests, strict=True):
            if rests:
                found.append(
                    said(
                        "{cart} stands still before the touch: its velocity there is 0.", cart=name
                    )
                )
    return [*found, of_law(synthetic=synthetic)]


ABOVE_ONE = said(
    "e is above 1: the carts would part faster than they came. A bumper cannot do that. Check the "
    "length scale and the frame rate, or look for a spring that was wound up."
)
NOT_RANDOM = said(
    "The residuals are not random: neighbours are alike. Either the readings err alike for many "
    "frames, which the intervals count, or the model lacks something that these carts do "
    "(friction, a tilt, a second contact, a hand), and the real uncertainty is larger than printed."
)


def of_loss(share: float) -> list[str]:
    """What friction in the contact does to the ratio of the masses."""
    if not share:
        return []
    told = said(
        "A bumper that hits beside the centre tips its cart, and the cart rubs while they touch. "
        "No film shows it; the interval of the mass ratio counts {percent} % of the push for it.",
        percent=number(100.0 * share, 1),
    )
    return [told]


def of_balance(
    ratio: Known | None,
    masses: Mapping[str, float],
    names: tuple[str, str],
    *,
    synthetic: bool = False,
) -> str:
    """Both masses weighed: the ratio from the balance beside the one from the motion."""
    if ratio is None or len(masses) < 2:
        return ""
    weighed = masses[names[1]] / masses[names[0]]
    both = said(
        "By balance the mass of {b} is {times} times that of {a}, from the motion {ratio}.",
        a=names[0],
        b=names[1],
        times=number(weighed, 3),
        ratio=with_half(ratio.value, ratio.half, ""),
    )
    if not ratio.low <= weighed <= ratio.high:
        verdict = said(
            "They do not agree within the interval. Look for friction, a tilt, or a wrong scale "
            "before you doubt the law."
        )
    elif synthetic:
        verdict = said("They agree, as they must.")
    else:
        verdict = said(
            "They agree: each cart changed the other's motion as Newton's third law says, within "
            "this uncertainty."
        )
    return joined(both, verdict)
