"""What a fit says, in short sentences, and what it cannot say."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from sim.measured.model.effects import (
    ALIKE,
    AS_GOOD,
    CHANCE,
    Compared,
    called_for,
    rms_residual,
    standing,
    undecided,
)
from sim.measured.model.fit import Fit
from sim.measured.model.quantity import Known
from sim.measured.model.unknowns import RUBS, Effect
from sim.scene.notation import number

LAWS = {
    "bumper": "the bumper law: the force starts from zero and never pulls",
    "paper": "the paper's law: spring and damper, until the bumper is clear",
}
EFFECTS = {
    "none": "nothing but the contact",
    "friction": "friction on each cart",
    "tilt": "a tilt of the track",
    "both": "friction on each cart and a tilt of the track",
}
FASTEST = 10.0
"""m/s. Carts in a school are slower."""

PROGRAM = (
    "The mass ratio comes out of the third law, which this model has built in. Weigh both carts: "
    "if the ratio from the balance is the same, your carts have confirmed it."
)

SYNTHETIC = "A program that was told the third law made these readings: no evidence for it."


def places_for(half: float) -> int:
    """Decimals that show an uncertainty with two digits."""
    if not (math.isfinite(half) and half > 0.0):
        return 6
    return min(15, max(0, 1 - math.floor(math.log10(half))))


def with_half(value: float, half: float, unit: str) -> str:
    """0.801 ± 0.002 m/s."""
    places = places_for(half)
    return f"{number(value, places)} ± {number(half, places)}{f' {unit}' if unit else ''}"


def of_known(one: Known) -> str:
    """One line."""
    if one.key == "e" and (one.high >= 1.0 or one.low <= 0.0):  # cut off at what is possible
        places = places_for(one.half)
        return f"{one.name}: from {number(one.low, places)} to {number(one.high, places)}"
    text = f"{one.name}: {with_half(one.value, one.half, one.unit)}"
    if one.alone:
        half = 0.5 * (one.alone[1] - one.alone[0])
        return text + f" (the readings alone: ± {number(half, places_for(half))})"
    middle = 0.5 * (one.low + one.high)
    if abs(middle - one.value) > 0.1 * one.half:  # a lopsided interval is told by its ends
        places = places_for(one.half)
        text += f" (from {number(one.low, places)} to {number(one.high, places)})"
    return text


def of_law(*, synthetic: bool) -> str:
    """Where a ratio of masses comes from, and what would confirm it; `synthetic`: nothing can."""
    return SYNTHETIC if synthetic else PROGRAM


def of_fit(
    fit: Fit, names: tuple[str, str], compared: Sequence[Compared], *, synthetic: bool
) -> list[str]:
    """What a reader should know beside its numbers; `synthetic`: a program made the readings."""
    said = []
    e, half = fit.parameters.e, fit.factor * fit.sd("e")
    if e - half > 1.0:
        said.append(
            "e is above 1: the carts would part faster than they came. A bumper cannot do that. "
            "Check the length scale and the frame rate, or look for a spring that was wound up."
        )
    fastest = max(map(abs, fit.parameters.v))
    if fastest > FASTEST:
        said.append(
            f"A cart moves with {number(fastest, 0)} m/s here. Are lengths and times really "
            "in the units that stand above?"
        )
    if fit.heavy:
        what = "1 reading counts" if fit.heavy == 1 else f"{fit.heavy} readings count"
        said.append(
            f"{what} less than the others (Huber's loss beyond four standard deviations from the "
            "model)."
        )
    row = next((one for one in compared if one.effect == fit.asked.effect), None)
    if row and row.alike > ALIKE:
        said.append(
            "The residuals are not random: neighbours are alike. Either the readings err alike for "
            "many frames, which the intervals count, or the model lacks something that these carts "
            "do (friction, a tilt, a second contact, a hand), and the real uncertainty is larger "
            "than printed."
        )
    if fit.asked.effect in RUBS:
        for name, rests in zip(names, fit.parameters.rests, strict=True):
            if rests:
                said.append(f"{name} stands still before the touch: its velocity there is 0.")
    said.append(of_law(synthetic=synthetic))
    return said


def of_loss(share: float) -> list[str]:
    """What friction in the contact does to the ratio of the masses."""
    if not share:
        return []
    return [
        "A bumper that hits beside the centre tips its cart, and the cart rubs while they touch. "
        "No film shows it; the interval of the mass ratio counts "
        f"{number(100.0 * share, 1)} % of the push for it."
    ]


def of_effects(compared: Sequence[Compared], names: tuple[str, str]) -> list[str]:
    """Which effects the residuals call for."""
    if len(compared) < 2:
        return []  # nothing to compare with
    rows = [
        f"{EFFECTS[row.effect]}: {number(1e3 * rms_residual(row.fit), 2)} mm" for row in compared
    ]
    wanted = called_for(list(compared))
    plain = rms_residual(compared[0].fit)
    if wanted == "none":
        verdict = (
            "Neither friction nor a tilt makes the residuals smaller than chance would: these "
            "readings do not call for them. It does not show that there is none."
        )
    else:
        best = next(rms_residual(row.fit) for row in compared if row.effect == wanted)
        times = plain / best if best else math.inf
        how = f"{number(times, 1)} times smaller" if times >= 1.05 else "a little smaller"
        how = "as good as gone" if times > 100.0 else how
        verdict = (
            f"With {EFFECTS[wanted]} the residuals are {how}, and chance alone does that less than "
            f"once in {round(1.0 / CHANCE)} films: "
        )
        resting = " and ".join(n for n, s in zip(names, standing(compared), strict=True) if s)
        if wanted == "tilt" and resting:
            verdict += (
                f"something pushes beside the contact. But {resting} stands still before the "
                "touch, and on a tilted track a free cart rolls: friction holds it, or it was "
                "held. These readings do not tell friction from a tilt. Lay a cart on the track "
                "and see whether it starts to roll."
            )
        elif undecided(compared):
            verdict += (
                "something pushes beside the contact. Friction and a tilt leave nearly the same: "
                "these readings do not tell which of both it is."
            )
        else:
            verdict += "this scene calls for it."
    return ["Root mean square of the residuals with " + "; with ".join(rows) + ".", verdict]


UNNAMED = (
    "This model does not fit these readings: these carts do something that is not in it. The "
    "numbers are off by more than they say, and their intervals do not count."
)
"""Where a lesson asks which effect its film calls for."""


def head_of(
    fitted: Effect, rows: Sequence[Compared], wanted: Effect | None, *, named: bool
) -> dict[str, str]:
    """What stands above the numbers: `added`, what these readings call for, where that was wanted;
    `doubt`, that it is missing where another was chosen (narrow intervals stand around wrong
    numbers then), by its name if it may be `named`. Of two that leave nearly the same either does.
    """
    if wanted is None:
        what = EFFECTS[fitted].capitalize()
        added = f"{what} was added: without it this model does not fit the readings."
        if fitted == "none":
            added = "Nothing was added: these readings call for neither friction nor a tilt."
        return {"added": added}
    left = {row.effect: row.noise for row in rows}
    best = called_for(list(rows))
    if best in ("none", fitted) or (fitted != "none" and left[fitted] < AS_GOOD * left[best]):
        return {}
    what = f"{EFFECTS['friction']} or {EFFECTS['tilt']}" if undecided(rows) else EFFECTS[best]
    doubt = (
        f"These readings call for {what}, and this fit is without: its numbers are off by more "
        "than they say, and their intervals do not count."
    )
    return {"doubt": doubt if named else UNNAMED}


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
    text = (
        f"By balance the mass of {names[1]} is {number(weighed, 3)} times that of {names[0]}, from "
        f"the motion {with_half(ratio.value, ratio.half, '')}. "
    )
    if ratio.low <= weighed <= ratio.high:
        if synthetic:
            return text + "They agree, as they must."
        return text + (
            "They agree: each cart changed the other's motion as Newton's third law says, within "
            "this uncertainty."
        )
    return text + (
        "They do not agree within the interval. Look for friction, a tilt, or a wrong scale before "
        "you doubt the law."
    )
