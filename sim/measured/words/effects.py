"""Which effects beside the contact the residuals call for, in sentences."""

from __future__ import annotations

import math
from collections.abc import Sequence

from sim.measured.model.effects import (
    AS_GOOD,
    CHANCE,
    Compared,
    called_for,
    rms_residual,
    standing,
    undecided,
)
from sim.measured.model.unknowns import Effect
from sim.scene.notation import number
from sim.scene.said import Said, listed, listed_or, said

EFFECTS = {
    "none": said("nothing but the contact"),
    "friction": said("friction on each cart"),
    "tilt": said("a tilt of the track"),
    "both": said("friction on each cart and a tilt of the track"),
}
ADDED = {
    "none": said("Nothing was added: these readings call for neither friction nor a tilt."),
    "friction": said(
        "Friction on each cart was added: without it this model does not fit the readings."
    ),
    "tilt": said("A tilt of the track was added: without it this model does not fit the readings."),
    "both": said(
        "Friction on each cart and a tilt of the track was added: without it this model does not "
        "fit the readings."
    ),
}


def of_effects(compared: Sequence[Compared], names: tuple[str, str]) -> list[str]:
    """Which effects the residuals call for."""
    if len(compared) < 2:
        return []  # nothing to compare with
    rows = ""
    for row in compared:
        size = number(1e3 * rms_residual(row.fit), 2)
        one = said("{effect}: {size} mm", effect=EFFECTS[row.effect], size=size)
        rows = said("{first}; with {then}", first=rows, then=one) if rows else one
    each = said("Root mean square of the residuals with {rows}.", rows=rows)
    wanted = called_for(list(compared))
    if wanted == "none":
        return [each, said(
            "Neither friction nor a tilt makes the residuals smaller than chance would: these "
            "readings do not call for them. It does not show that there is none."
        )]  # fmt: skip
    best = next(rms_residual(row.fit) for row in compared if row.effect == wanted)
    verdict = said(
        "With {effect} the residuals are {smaller}, and chance alone does that less than once in "
        "{films} films: {so}",
        effect=EFFECTS[wanted],
        smaller=_smaller(rms_residual(compared[0].fit), best),
        films=str(round(1.0 / CHANCE)),
        so=_so(wanted, compared, names),
    )
    return [each, verdict]


def _smaller(plain: float, best: float) -> Said:
    times = plain / best if best else math.inf
    if times > 100.0:
        return said("as good as gone")
    if times >= 1.05:
        return said("{times} times smaller", times=number(times, 1))
    return said("a little smaller")


def _so(wanted: Effect, compared: Sequence[Compared], names: tuple[str, str]) -> Said:
    """What an effect that the residuals call for means."""
    resting = [n for n, s in zip(names, standing(compared), strict=True) if s]
    if wanted == "tilt" and resting:
        return said(
            "something pushes beside the contact. But {resting} stands still before the touch, and "
            "on a tilted track a free cart rolls: friction holds it, or it was held. These "
            "readings do not tell friction from a tilt. Lay a cart on the track and see whether it "
            "starts to roll.",
            resting=listed(resting),
        )
    if undecided(compared):
        return said(
            "something pushes beside the contact. Friction and a tilt leave nearly the same: these "
            "readings do not tell which of both it is."
        )
    return said("this scene calls for it.")


UNNAMED = said(
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
        return {"added": ADDED[fitted]}
    left = {row.effect: row.noise for row in rows}
    best = called_for(list(rows))
    if best in ("none", fitted) or (fitted != "none" and left[fitted] < AS_GOOD * left[best]):
        return {}
    either = listed_or([EFFECTS["friction"], EFFECTS["tilt"]])
    doubt = said(
        "These readings call for {effect}, and this fit is without: its numbers are off by more "
        "than they say, and their intervals do not count.",
        effect=either if undecided(rows) else EFFECTS[best],
    )
    return {"doubt": doubt if named else UNNAMED}
