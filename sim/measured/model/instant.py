"""Where a brake was fitted, a contact may be shorter than the fit has it.

A few readings tell how long a short contact lasts, by less than a millimetre. What the form of a
brake is off by (a drag beside the friction, a track that is not even) is as large there, and makes
a contact of no length last for three frames. One that leaves nearly as little is as likely.
"""

from __future__ import annotations

import math
from dataclasses import replace

from sim.measured.model.effects import AS_GOOD
from sim.measured.model.fit import Fit, fit
from sim.measured.model.lasting import MEANS, frame_of
from sim.measured.refusal import FitError
from sim.measured.tracks import Measured

SURELY = 10.8
"""Mean squares: what a length gains by chance once in a thousand (χ² of one unknown), as an
effect may (`effects.CHANCE`); of many readings AS_GOOD: a wrong form is no chance."""

SHORT, FOUND = 0.2, 0.8
"""Frames: a contact that no reading need lie in; and what a descent from there must stay below."""


def perhaps_instant(made: Fit, measured: Measured) -> Fit:
    """The fit, no surer of touch and stiffness than an instant contact lets it be; `measured`: the
    readings that were fitted."""
    p, frame = made.parameters, frame_of(measured)
    if made.asked.effect == "none" or not SHORT * frame < made.duration < MEANS * frame:
        return made
    start = replace(p, w0=p.w0 * made.duration / (SHORT * frame),
                    touch=p.touch + 0.5 * (made.duration - SHORT * frame))  # fmt: skip
    try:
        other = fit(measured, made.asked, start)
    except FitError:
        return made
    most = max(AS_GOOD**2, 1.0 + SURELY / made.freedom) * made.squares
    if other.duration > FOUND * frame or other.squares > most:
        return made
    wide = [list(row) for row in made.covariance]
    for name, apart in (("ln_w0", math.log(other.parameters.w0 / p.w0)),
                        ("touch", other.parameters.touch - p.touch)):  # fmt: skip
        if name in made.unknowns:
            k = made.unknowns.index(name)
            wide[k][k] += apart**2
    return replace(made, covariance=tuple(tuple(row) for row in wide))
