"""What each outcome tells, with intervals.

By the third law m_A Δv_A = −m_B Δv_B, so the ratio of the masses is −Δv_A/Δv_B. A track takes a
part of the push away while the carts touch: a bumper that hits above or below the centre of mass
tips its cart, and the cart rubs. Such friction is against each cart's motion, and at most a share
LOSS of the push itself (more in a hard push, and where both changes do not run in step). It is not
seen; the ratio is put right by what is likely, and its interval counts all of it:

    m_B/m_A = −Δv_A/Δv_B (1 − f (s_A + s_B)) ,   0 ≤ f ≤ LOSS ,   s the direction of motion
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from sim.measured.events.contacts import Contact
from sim.measured.events.in_step import StepMatch
from sim.measured.events.outcome import AT_REST, HALF, Outcome, spread
from sim.measured.events.sides import Speeds
from sim.measured.events.together import Together
from sim.measured.model.believable import TOO_WIDE, bounciness
from sim.measured.model.known import BOUNCINESS, EACH_MASS, of_mass, of_ratio
from sim.measured.model.quantity import Known, Untold, known_and_untold, not_shown
from sim.scene.said import said

LOSS = 0.018
"""Share of the push that friction in the contact takes at most. From nine weighed collisions on an
air track: 0.3 to 1.5 % where the push was soft, up to 4 % where it was hard."""

HARD = 0.05
"""Times (1 − e)²: what a bounce that loses most of its energy may take beside."""

LIKELY = 0.7
"""Of what friction may take, the share by which the ratio is put right; the interval reaches from
a little below none to more than all of it."""

SCALES = 0.04
"""Half of a 95 % interval: two sensors may read lengths that differ by so much (three weighed
explosions differ by 2 to 4 %). One film cannot."""

STEPPED = 3.0
"""Times the distance between both changes' curves: what a hard push takes."""

FINE = 12
"""Cells of a contact in which that distance can be judged."""

TURN, SLOWEST = 1e-6, 1e-3
"""A velocity is changed by TURN of the fastest to see what follows, and of SLOWEST [m/s] at least:
so little that the slopes are straight, so much that rounding is 1e-10 of them."""

NOISELESS = 1e-9
"""Of the fastest velocity: the least standard deviation, so that readings without any noise have an
interval too."""

NO_SPEED = 1e-12
"""m/s. Stands for a difference that is nought: the quotient is out of all bounds, and not told."""

WIDEST_RATIO = 0.5
"""Relative half-width above which a ratio is not printed."""

MOST_LOST = 0.2
"""Share of the push. No friction in a contact takes so much (LOSS, HARD): what seems lost is that
the two velocities do not change together."""

NOT_IN_STEP = (
    "the two carts do not change their velocity in step: something else pushes, or the contact "
    "is not where it seems to be"
)

Values = Sequence[float]


def slopes_of(function: Callable[[Values], float], v: Values) -> list[float]:
    """Derivatives by the four velocities."""
    size = TURN * max(SLOWEST, *map(abs, v))
    found = []
    for k in range(4):
        up, down = list(v), list(v)
        up[k], down[k] = up[k] + size, down[k] - size
        found.append((function(up) - function(down)) / (2.0 * size))
    return found


def loss(v: Values, step: StepMatch | None, outcome: Outcome) -> float:
    """Share of the push that friction may take in this contact; `v` before and after, in m/s."""
    if outcome != "bounce":
        return LOSS
    e = min(max((v[3] - v[2]) / (v[0] - v[1]), 0.0), 1.0)
    hard = LOSS + HARD * (1.0 - e) ** 2
    return max(hard, STEPPED * step.surely) if step and step.cells >= FINE else hard


def with_loss(one: Known, share: float) -> Known | Untold:
    """A ratio of masses from a model without friction in the contact, its interval with it; not
    told where both carts do not change their velocity in step, or where it is too wide."""
    if share > MOST_LOST:
        return Untold(one.key, one.name, NOT_IN_STEP)
    if math.hypot(0.5 * math.log(one.high / one.low), share) > WIDEST_RATIO:
        return Untold(one.key, one.name, TOO_WIDE)
    factor = math.exp(math.hypot(0.5 * math.log(one.high / one.low), share))
    return replace(one, low=one.value / factor, high=one.value * factor,
                   sd=one.value * math.log(factor) / HALF, alone=(one.low, one.high))  # fmt: skip


def directions(v: Values) -> tuple[int, int]:
    """Of both carts while they touch: −1, 0, 1; `v` before and after."""
    greatest = max(map(abs, v))
    means = [0.5 * (v[k] + v[k + 2]) for k in (0, 1)]
    first, second = (0 if abs(m) < AT_REST * greatest else 1 if m > 0 else -1 for m in means)
    return first, second


def quantities_of_outcome(
    outcome: Outcome,
    speeds: Speeds,
    contact: Contact,
    step: StepMatch,
    names: tuple[str, str],
    masses: Mapping[str, float] | None = None,
    two: bool = False,
    beside: Together | None = None,
) -> tuple[list[Known], list[Untold]]:
    """Known and untold quantities; every interval is finite and has a width. `beside`: how the
    distance grows afterwards, where the velocities alone tell no parting."""
    found: list[Known | Untold] = []

    def add(key: str, name: str, function: Callable[[Values], float], unit: str) -> None:
        found.append(_plain(speeds, key, name, function, unit))

    if outcome == "bounce":
        found.append(_bounciness(speeds, beside))
    ratio = mass_ratio(speeds, step, outcome, names, two)
    found.append(ratio)
    if outcome != "explosion":
        for k, name in enumerate(names):
            add(f"v_{'ab'[k]}", said("velocity of {cart} before", cart=name), _velocity(k), "m/s")
    if outcome == "stick":
        add("v_common", said("common velocity after"), lambda v: 0.5 * (v[2] + v[3]), "m/s")
        add("energy_lost", said("energy lost per reduced mass"),
            lambda v: 0.5 * (v[0] - v[1]) ** 2, "J/kg")  # fmt: skip
        limit = beside.below(speeds.approach) if beside else None
        found.append(Untold("e", BOUNCINESS, _no_rebound(limit)))
    else:
        for k, name in enumerate(names):
            add(
                f"v_{'ab'[k]}_after",
                said("velocity of {cart} after", cart=name),
                _velocity(k + 2),
                "m/s",
            )
    if outcome == "explosion":
        add("parting", said("the carts part at"), lambda v: v[3] - v[2], "m/s")
        add("energy_released", said("energy released per reduced mass"),
            lambda v: 0.5 * ((v[3] - v[2]) ** 2 - (v[1] - v[0]) ** 2), "J/kg")  # fmt: skip
        reason = said("the carts were together before: nothing is thrown back")
        found.append(Untold("e", BOUNCINESS, reason))
    found += [_middle(contact), *_weighed(ratio, names, masses or {})]
    return known_and_untold(found)


def _no_rebound(limit: float | None) -> str:
    """Why e is not told where the carts stay together; `limit`: what it is below."""
    if not limit:
        return said("the carts stay together: there is no rebound")
    return said(
        "the carts stay together as far as readings show: e is below {limit}", limit=f"{limit:.2f}"
    )


def _middle(contact: Contact) -> Known:
    half = 0.5 * (contact.end - contact.begin)
    ends = contact.middle - half, contact.middle + half
    name = said("middle of the contact at t")
    return Known("touch", name, contact.middle, *ends, half / HALF, "s")


def _velocity(k: int) -> Callable[[Values], float]:
    return lambda v: v[k]


def _plain(
    speeds: Speeds, key: str, name: str, function: Callable[[Values], float], unit: str
) -> Known:
    value, sd = function(speeds.v), spread(speeds, slopes_of(function, speeds.v))
    sd = max(sd, NOISELESS * max(map(abs, speeds.v)))
    return Known(key, name, value, value - HALF * sd, value + HALF * sd, sd, unit)


def _bounciness(speeds: Speeds, beside: Together | None) -> Known | Untold:
    """e within 0 and 1. Where only the distance tells that the carts part, its e, and all that
    either allows."""
    one = _plain(speeds, "e", BOUNCINESS, lambda v: (v[3] - v[2]) / (v[0] - v[1] or NO_SPEED), "")
    if beside:
        e, least, most = (w / speeds.approach for w in (beside.value, beside.low, beside.high))
        one = replace(one, value=e, low=min(one.low, least), high=max(one.high, most))
        one = replace(one, sd=0.5 * (one.high - one.low) / HALF)
    return bounciness(one)


def mass_ratio(
    speeds: Speeds, step: StepMatch, outcome: Outcome, names: tuple[str, str], two: bool = False
) -> Known | Untold:
    """B ÷ A, with what friction in the contact may take; `two` sensors, each with its scale."""
    name = of_ratio(names)

    def raw(v: Values) -> float:
        return -(v[2] - v[0]) / ((v[3] - v[1]) or NO_SPEED)

    value = raw(speeds.v)
    share, both = loss(speeds.v, step, outcome), directions(speeds.v)
    shift = 0.5 * LIKELY * share * (both[0] + both[1])
    parts = spread(speeds, slopes_of(raw, speeds.v)) / abs(value), share / HALF
    sd = math.hypot(*parts, SCALES / HALF if two else 0.0)
    value *= 1.0 - shift
    if not (value > 0.0 and HALF * sd < WIDEST_RATIO):
        return Untold("mass_ratio", name, TOO_WIDE)
    factor = math.exp(HALF * sd)
    return Known("mass_ratio", name, value, value / factor, value * factor, value * sd, "")


def _weighed(
    ratio: Known | Untold, names: tuple[str, str], masses: Mapping[str, float]
) -> list[Known | Untold]:
    """The other mass where one is weighed; where none is, that no mass can be told."""
    if not masses:
        return [Untold("mass", EACH_MASS, not_shown(said("both masses")))]
    if isinstance(ratio, Untold) or len(masses) > 1:
        return []
    ((name, kg),) = masses.items()
    other = 1 - names.index(name)
    ends = [ratio.value, ratio.low, ratio.high]
    value, *sides = [kg * q if other else kg / q for q in ends]
    sd = ratio.sd / ratio.value * value
    return [Known("mass", of_mass(names[other]), value, min(sides), max(sides), sd, "kg")]
