"""What a brake of another form would change: the model's numbers beside those of the velocities.

The model brakes its carts over the whole film by one form (friction that does not depend on speed,
a tilt); real carts have bearings, air and a track that is not even, and noise hides which. The
velocities beside the contact use less of the film and try several forms (`events.brakes`). Where
readings do not tell these apart, the model's numbers are no surer than the velocities. If both told
the truth they would differ by the noise of the velocities, for the model uses all of their readings
(Hausman 1978, “Specification tests in econometrics”). What they differ by beyond that is an error
of form, and nobody knows whose: half of it counts too.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace

from sim.measured.events.brakes import Step
from sim.measured.model.fit import Fit
from sim.measured.model.lasting import frame_of
from sim.measured.model.motion import Parameters
from sim.measured.model.quantity import Known
from sim.measured.tracks import Measured

HALF = 0.5
"""Of a difference that is an error of form: as likely the one's as the other's."""

TOLD = 1.5
"""Times what the model's form misses readings by that were left out: from there another form is not
the true one. By chance two forms that do as well differ by a fifth."""

BESIDE = 2
"""Frames before and after a push in which another shape is seen: a smoother's, a soft end's."""

THERE = 3
"""Unknowns that these readings tell nearly alone: touch, stiffness, e."""

CHANCE = 0.01
"""That noise alone is as much louder there. With 0.05 the intervals of 80 films of the model itself
become 13 % wider in the mean, with this 3 %."""


def another_push(made: Fit, measured: Measured) -> bool:
    """Whether what is left over in the contact and beside it is more than elsewhere: the push has
    not the shape of the model's, which moves touch and velocities. `measured`: what was fitted."""
    import numpy as np
    from scipy.special import fdtrc

    p, wide = made.parameters, BESIDE * frame_of(measured)
    squares = np.square(np.concatenate(made.residuals))
    t = np.concatenate([track.t for track in measured.tracks])
    there = (t > p.touch - wide) & (t < p.touch + made.duration + wide)
    few, many = int(np.sum(there)) - THERE, int(np.sum(~there))
    others = float(np.sum(squares[~there]))
    if min(few, many) < 1 or others == 0.0:
        return False
    louder = float(np.sum(squares[there])) / few * many / others
    return bool(fdtrc(few, many, louder) < CHANCE)


def form_told(effect: Step, held_out: Iterable[tuple[Step, float]]) -> bool:
    """Whether the velocities' ladder (each step with what it misses, m) tells the form of the brake
    from the other ones."""
    missed: dict[Step, float] = {step: error for step, error in held_out if step != "nothing"}
    # both hold either, and always do as well
    others = {step for step in missed if step not in (effect, "both")}
    return all(missed[step] > TOLD * missed[effect] for step in others)


def doubted(made: Fit, velocities: Iterable[Known], *, told: bool) -> Fit:
    """The fit, with e, the ratio of masses and both velocities before no surer than the velocities
    beside the contact let them be; `told`: the form of the brake is known."""
    if made.asked.effect == "none":
        return made
    p, rows = made.parameters, [list(row) for row in made.covariance]
    listed = list(velocities)
    middle = next((one.value for one in listed if one.key == "touch"), p.touch)
    for one in listed:
        if one.key == "e":
            name, apart, sd = "e", p.e - one.value, one.sd
        elif one.key == "mass_ratio":
            name, apart, sd = "ln_ratio", math.log(p.ratio / one.value), one.sd / one.value
        elif one.key in ("v_a", "v_b"):
            cart = "ab".index(one.key[-1])
            name, sd = f"v{cart + 1}", one.sd
            apart = _going_on(p, cart, middle) - one.value
        else:
            continue
        if name not in made.unknowns:
            continue  # a cart that stands
        k = made.unknowns.index(name)
        rows[k][k] = rows[k][k] if told else max(rows[k][k], sd**2)
        rows[k][k] += HALF**2 * max(apart**2 - sd**2, 0.0)
    return replace(made, covariance=tuple(tuple(row) for row in rows))


def _going_on(p: Parameters, cart: int, t: float) -> float:
    """m/s. The velocity before, at a time near the touch, as if there were no contact."""
    brake = math.copysign(p.friction[cart], p.v[cart]) if p.v[cart] else 0.0
    return p.v[cart] + (p.tilt - brake) * (t - p.touch)
