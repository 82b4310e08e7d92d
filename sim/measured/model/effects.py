"""Which effects do these readings call for? The residuals say.

The model is fitted without anything, with friction, with a tilt, and where either is called for
with both. An effect is called for when the sum of squares falls by more than chance would make it
fall (F-test, 1 of 1000; where noise lasts, what is gained is divided by how much more such noise
gains), both when it falls so beside the better one. Residuals that follow each
other (neighbours alike) tell that something may still be missing; then no interval that takes the
residuals for chance, lasting or not, is wide enough.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from sim.measured.events.correlated import inflation
from sim.measured.model.fit import Asked, Fit, fit
from sim.measured.model.motion import Parameters
from sim.measured.model.unknowns import Effect
from sim.measured.refusal import FitError
from sim.measured.tracks import Measured

CHANCE = 1e-3
AS_GOOD = 1.05
"""Times the smaller noise: two effects that leave so nearly the same are not told apart."""

ALIKE = 0.35
"""Correlation of neighbouring residuals above which they are no chance."""


@dataclass(frozen=True, slots=True)
class Compared:
    """One effect beside the model without any, both beside the better one. `chance`: that luck
    alone does as well."""

    effect: Effect
    noise: float  # m, standard deviation of the residuals
    chance: float | None  # None: for "none"
    alike: float
    fit: Fit


def compare(
    measured: Measured,
    plain: Fit,
    effects: Sequence[Effect] = ("friction", "tilt", "both"),
    wanted: Effect | None = None,
) -> list[Compared]:
    """The plain fit, and the same with each effect that can be fitted; both where either is called
    for, or where they are `wanted`."""
    import numpy as np
    from scipy.special import fdtrc

    rows = [Compared("none", plain.noise, None, neighbours(plain), plain)]
    for effect in effects:
        asked = Asked(law=plain.asked.law, effect=effect, distance=plain.asked.distance)
        simpler = plain
        if effect == "both":
            if (one := called_for(rows)) == "none" and wanted != "both":
                continue
            simpler = next(row.fit for row in rows if row.effect == one)
        try:
            start = simpler.parameters if effect == "tilt" else _braking(simpler)
            with_it = fit(measured, asked, start)
        except FitError:
            continue
        more = simpler.freedom - with_it.freedom
        gained = (simpler.squares - with_it.squares) / max(more, 1)
        variance = with_it.squares / with_it.freedom
        chance = 1.0
        # Noise that lasts bends a track as friction does: it gains more by chance than white noise.
        _, lasting = inflation([np.array(track) for track in with_it.residuals])
        gained /= lasting
        if gained > 0.0 and variance > 0.0 and more > 0:
            chance = float(fdtrc(more, with_it.freedom, gained / variance))
        elif with_it.squares < simpler.squares:
            chance = 0.0
        rows.append(Compared(effect, with_it.noise, chance, neighbours(with_it), with_it))
    return rows


def _braking(plain: Fit) -> Parameters:
    """A start with a little friction, so that it is not on the edge."""
    p = plain.parameters
    first, second = (max(one, 0.01) for one in p.friction)
    return replace(p, friction=(first, second))


def called_for(rows: list[Compared]) -> Effect:
    """The effect that the residuals call for: the one that leaves least, if it is no chance."""
    real = [row for row in rows if row.chance is not None and row.chance < CHANCE]
    return min(real, key=lambda row: row.noise).effect if real else "none"


def standing(rows: Sequence[Compared]) -> tuple[bool, bool]:
    """Which carts stand still before the touch, as the fit with friction found."""
    return next((row.fit.parameters.rests for row in rows if row.effect == "friction"),
                (False, False))  # fmt: skip


def undecided(rows: Sequence[Compared]) -> bool:
    """Whether friction and a tilt are both no chance and leave nearly the same."""
    real = {r.effect: r.noise for r in rows if r.chance is not None and r.chance < CHANCE}
    if "both" in real:
        return False
    return len(real) > 1 and max(real.values()) < AS_GOOD * min(real.values())


def rms_residual(fit: Fit) -> float:
    """m. Root mean square of the residuals, as under the picture: a model that was set by hand has
    it too, and no degrees of freedom."""
    every = list(itertools.chain(*fit.residuals))
    return math.sqrt(sum(r * r for r in every) / len(every))


def neighbours(fit: Fit) -> float:
    """Correlation of neighbouring residuals, both carts taken together."""
    above = below = 0.0
    for track in fit.residuals:
        mean = sum(track) / len(track)
        left = [value - mean for value in track]
        above += sum(a * b for a, b in itertools.pairwise(left))
        below += sum(a * a for a in left)
    return above / below if below > 0.0 else 0.0
