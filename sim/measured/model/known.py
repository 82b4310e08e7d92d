"""What the readings tell, with intervals, and what they cannot tell.

A motion shows e, the ratio of the masses, when the touch is, and sqrt(k/mu) if frames lie inside
the contact. It never shows a mass in kg or k in N/m: with all masses and k doubled the same film
comes out. With one mass from a balance both masses and k follow.
"""

from __future__ import annotations

import math

from sim.measured.model.fit import Fit
from sim.measured.model.lasting import by_any_law
from sim.measured.model.motion import GRAVITY, Motion
from sim.measured.model.quantity import Known, Untold, known_and_untold, not_shown
from sim.measured.model.unknowns import LEANS, RUBS
from sim.scene.said import Said, said

WIDEST_LOG = 0.5
"""Standard deviation of ln w0, or of any logarithm, above which no number is printed."""


BOUNCINESS = said("bounciness e")
LASTS = said("the contact lasts")
SWING = said("swing of the bumpers, √(k/μ)")
STIFFNESS = said("stiffness k in N/m")
EACH_MASS = said("mass of each cart in kg")

BY_DEVICE = said(
    "few readings lie inside the contact, and means of readings (a logger's, or of a film that was "
    "smoothed) make any contact look as long. Take more readings per second, and do not smooth them"
)


def of_mass(cart: str) -> Said:
    """What the mass of one cart is called."""
    return said("mass of {cart}", cart=cart)


def of_ratio(names: tuple[str, str]) -> Said:
    """What the ratio of both masses is called."""
    return said("mass of {b} ÷ mass of {a}", a=names[0], b=names[1])


def quantities_of_fit(
    fit: Fit,
    names: tuple[str, str],
    mass: tuple[str, float] | None = None,
    smoothed: float = 0.0,
) -> tuple[list[Known], list[Untold]]:
    """Everything that this fit says, and what it does not. `mass`: of one cart, in kg; `smoothed`:
    in s, how long a logger may make a contact look by itself."""
    p = fit.parameters
    found: list[Known | Untold] = [
        _plain(fit, "e", BOUNCINESS, p.e, {"e": 1.0}, ""),
        _log(fit, "mass_ratio", of_ratio(names), p.ratio, {"ln_ratio": 1.0}, ""),
    ]
    for k, name in enumerate(names):
        if p.rests[k]:
            continue  # it is known to stand still
        key = f"v_{'ab'[k]}"
        slopes = {f"v{k + 1}": 1.0}
        what = said("velocity of {cart} at the touch", cart=name)
        found.append(_plain(fit, key, what, p.v[k], slopes, "m/s"))
    found += _after(fit, names)
    found.append(_plain(fit, "touch", said("first touch at t"), p.touch, {"touch": 1.0}, "s"))
    stiff = {"ln_w0": 1.0}
    duration = {"ln_w0": -1.0, "e": _duration_by_e(fit)}
    lasts = _log(fit, "duration", LASTS, fit.duration, duration, "s")
    if isinstance(lasts, Known):
        lasts = by_any_law(lasts, p.e, p.e + fit.factor * fit.sd("e"))
    shortest = lasts.low if isinstance(lasts, Known) else fit.duration
    by_device = min(shortest, fit.duration) < smoothed
    swing = _log(fit, "w0", SWING, p.w0, stiff, "1/s")
    found += [_no_device(lasts, by_device), _no_device(swing, by_device)]
    for k, name in enumerate(names) if fit.asked.effect in RUBS else ():
        slopes = {f"friction{k + 1}": 1.0}
        what = said("deceleration of {cart} by friction", cart=name)
        brake = _plain(fit, f"friction_{'ab'[k]}", what, p.friction[k], slopes, "m/s²")
        found += [brake, _coefficient(brake, name)]
    if fit.asked.effect in LEANS:
        slopes = {"tilt": 1.0}
        what = said("acceleration by the tilt")
        found.append(_plain(fit, "tilt", what, p.tilt, slopes, "m/s²"))
    found += _masses(fit, names, mass, by_device=by_device)
    return known_and_untold(found)


def _after(fit: Fit, names: tuple[str, str]) -> list[Known]:
    """Both velocities when the carts part: v' = V ± e u m_other/M, of which a brake changes next to
    nothing within the contact, and the derivatives of that."""
    p = fit.parameters
    motion = Motion(p, fit.asked.law)
    if not math.isfinite(motion.duration):
        return []
    a = 1.0 / (1.0 + p.ratio)  # share of the mass that A has
    b, e, u = 1.0 - a, p.e, p.approach
    by_ratio = -(1.0 + e) * u * a * b  # of both: V, and what e adds to it
    slopes = (
        {"v1": a - b * e, "v2": b * (1.0 + e), "e": -b * u, "ln_ratio": by_ratio},
        {"v1": a * (1.0 + e), "v2": b - a * e, "e": a * u, "ln_ratio": by_ratio},
    )
    return [
        _plain(fit, f"v_{'ab'[k]}_after", said("velocity of {cart} after", cart=name),
               motion.after[1][k],
               {key: by for key, by in slopes[k].items() if key in fit.unknowns}, "m/s")
        for k, name in enumerate(names)
    ]  # fmt: skip


def _coefficient(brake: Known, name: str) -> Known:
    """Of a deceleration on a level track, where a = μ g."""
    what = said("coefficient of friction μ of {cart}, level track", cart=name)
    value, low, high, sd = (x / GRAVITY for x in (brake.value, brake.low, brake.high, brake.sd))
    return Known(brake.key.replace("friction", "mu"), what, value, low, high, sd, "")


def _masses(
    fit: Fit,
    names: tuple[str, str],
    mass: tuple[str, float] | None,
    *,
    by_device: bool,
) -> list[Known | Untold]:
    """The other mass and k if one mass is given, else why they are not there."""
    if mass is None:
        reason = not_shown(said("both masses and k"))
        return [Untold("mass", EACH_MASS, reason), Untold("k", STIFFNESS, reason)]
    weighed, kg = mass
    q, other = fit.parameters.ratio, 1 - names.index(weighed)
    sign = 1.0 if other == 1 else -1.0
    found_mass = _log(fit, "mass", of_mass(names[other]), kg * q**sign, {"ln_ratio": sign}, "kg")
    mass_a = kg if other == 1 else kg / q
    mu = mass_a * q / (1.0 + q)
    slope = 1.0 / (1.0 + q) if other == 1 else -q / (1.0 + q)
    k = _log(fit, "k", said("stiffness k"), mu * fit.parameters.w0**2,
             {"ln_w0": 2.0, "ln_ratio": slope}, "N/m")  # fmt: skip
    return [found_mass, _no_device(k, by_device)]


def _no_device(one: Known | Untold, by_device: bool) -> Known | Untold:
    """What a logger may have made by itself is not told."""
    return Untold(one.key, one.name, BY_DEVICE) if by_device and isinstance(one, Known) else one


def _plain(
    fit: Fit, key: str, name: str, value: float, slopes: dict[str, float], unit: str
) -> Known:
    sd = fit.spread(slopes)
    return Known(key, name, value, value - fit.factor * sd, value + fit.factor * sd, sd, unit)


def _log(
    fit: Fit, key: str, name: str, value: float, slopes: dict[str, float], unit: str
) -> Known | Untold:
    """The same for what is fitted by its logarithm; refused where the interval says nothing."""
    sd = fit.spread(slopes)
    if not sd <= WIDEST_LOG:
        if "ln_w0" in slopes:
            reason = said(
                "too few frames lie inside the contact. Film with more frames per second, use a "
                "softer bumper, or give the distance of the marks when the bumpers just touch"
            )
        else:
            reason = said("the readings leave it open: the velocities change too little")
        return Untold(key, name, reason)
    half = fit.factor * sd
    return Known(key, name, value, value * math.exp(-half), value * math.exp(half), value * sd,
                 unit)  # fmt: skip


def _duration_by_e(fit: Fit) -> float:
    """d ln(duration)/de of both laws."""
    e = fit.parameters.e
    if fit.asked.law == "bumper":
        return 1.0 / (1.0 + e)
    fade = math.log(max(e, 1e-6))
    return fade / (max(e, 1e-6) * (math.pi**2 + fade**2))
