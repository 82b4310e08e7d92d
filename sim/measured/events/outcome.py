"""Bounce, stick or explosion, from the velocities before and after.

With A on the left, u = v_A − v_B the approach and u' = v_B' − v_A' the parting:

    explosion   hardly an approach, a parting
    stick       an approach, no parting within the interval
    bounce      both; e = u'/u

What no contact of two carts can be is refused with a code and a sentence.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

from sim.measured.events.contacts import Contact
from sim.measured.events.in_step import StepMatch
from sim.measured.events.sides import Speeds
from sim.measured.refusal import FitError
from sim.scene.said import said

Outcome = Literal["bounce", "stick", "explosion"]
OUTCOMES: tuple[Outcome, ...] = ("bounce", "stick", "explosion")
HALF = 2.1
"""Half a 95 % interval in standard deviations (Student's t with some twenty readings)."""

STUCK, PERHAPS = 0.06, 0.12
"""e: below the first, or below the second with 0 inside of the interval, they stay together."""

HARDLY = 0.15
"""An approach below this share of the parting is none, if carts were to be at rest together."""

CHANGED = 3.0
"""Standard deviations that a velocity changes by, at least."""

LATE, LATE_AT_REST = 1.0, 0.6
"""Readings: a lag that the taking turns of two sensors explains; the second, where a cart stands
still afterwards, as it does for a sensor that has lost it."""

LATE_SHARE = 0.06
"""Of the contact: a lag that no one need explain."""

APART = 0.22
"""How far the shares of both changes may run apart, root mean square."""

ELASTIC = 0.85
"""e from which a cart that stands still after a contact is taken as such: equal masses, hardly any
loss."""

AT_REST = 0.06
"""Share of the greatest velocity below which a cart stands still."""

SAY_TOGETHER = said(
    "let the carts meet nearer to the middle, so that both run on within reach; or, if you saw "
    "that they stayed together, say so (--together, or the box on the page)"
)


def outcome_of(speeds: Speeds) -> Outcome:
    """What happened; raises FitError where no contact gives such velocities."""
    v = speeds.v
    u, parting = v[0] - v[1], v[3] - v[2]
    sd_u, sd_parting = spread(speeds, (1, -1, 0, 0)), spread(speeds, (0, 0, -1, 1))
    if parting > 0.0 and u < max(HARDLY * parting, min(HALF * sd_u, 0.5 * parting)):
        return "explosion"
    if u <= 0.0:
        raise FitError(
            said("the carts do not come closer to each other before this contact"),
            said(
                "choose another one, or check which cart is on the left and the signs of the "
                "sensors"
            ),
            "no-approach",
        )
    e, sd = parting / u, math.hypot(sd_parting, parting / u * sd_u) / u
    if e < -max(STUCK, HALF * sd):
        raise FitError(
            said("after the contact the carts still come closer: one would go through the other"),
            said("is a direction wrong, or did two marks change their places?"),
            "through-each-other",
        )
    if e < STUCK or (e < PERHAPS and e < HALF * sd):
        return "stick"
    if e > 1.0 + HALF * sd:
        raise FitError(
            said(
                "the carts part {percent} % faster than they came. A bumper cannot do that",
                percent=f"{100 * (e - 1):.0f}",
            ),
            said("is a spring wound up, does a hand push, or does a sensor read another scale?"),
            "gained-energy",
        )
    return "bounce"


def spread(speeds: Speeds, slopes: Sequence[float]) -> float:
    """Standard deviation of what has these derivatives by the four velocities."""
    rows = speeds.covariance
    total = sum(a * b * rows[i][k] for i, a in enumerate(slopes) for k, b in enumerate(slopes))
    return math.sqrt(max(total, 0.0))


def check_push(
    speeds: Speeds,
    step: StepMatch,
    contact: Contact,
    frame: float,
    names: tuple[str, str],
    lost: int | None = None,
) -> None:
    """Raises FitError if something else pushed, or a sensor lost its cart. `frame`: s; `lost`: the
    cart of which the reader says so."""
    v = speeds.v
    for k, name in enumerate(names):
        sd = spread(speeds, [(-1.0, 0, 1.0, 0), (0, -1.0, 0, 1.0)][k])
        if abs(v[k + 2] - v[k]) < CHANGED * sd:
            raise FitError(
                said(
                    "the velocity of {cart} changes by less than can be told from its readings",
                    cart=name,
                ),
                said("a faster push, or more readings beside the contact"),
                "no-change",
            )
    if lost is None:
        _in_time(speeds, step, contact, frame, names)


def _in_time(
    speeds: Speeds, step: StepMatch, contact: Contact, frame: float, names: tuple[str, str]
) -> None:
    v, late = speeds.v, 0 if step.lag > 0.0 else 1
    rests = _comes_to_rest(v, late)
    least = max(
        (LATE_AT_REST if rests else LATE) * frame, LATE_SHARE * (contact.end - contact.begin)
    )
    sure = max(abs(step.lag) - HALF * step.unsure, 0.0)
    if rests and sure > least:
        raise FitError(
            said(
                "{cart} stands still after the contact, but stops {time} s later than the other "
                "cart's velocity changes: its sensor lost it (the end of what it can read), or "
                "something else held it. Its velocity after the contact is not in the file",
                cart=names[late],
                time=f"{abs(step.lag):.2f}",
            ),
            SAY_TOGETHER,
            "lost-after",
        )
    if sure > 2.0 * least or step.surely > APART:
        raise FitError(
            said(
                "the two carts do not change their velocity in step ({cart} {time} s later): "
                "something else pushes, or a sensor lost its cart",
                cart=names[late],
                time=f"{abs(step.lag):.2f}",
            ),
            said("no hand, no end stop near the contact; both clocks the same"),
            "not-in-step",
        )


def perhaps_lost(speeds: Speeds) -> int | None:
    """Which cart comes and then stands still while the other moves on. It has met one of 1/e times
    its mass, or has left what its sensor can read, as a cart that sticks does."""
    v, still = speeds.v, AT_REST * max(map(abs, speeds.v))
    return next((k for k in (0, 1) if _comes_to_rest(v, k) and abs(v[3 - k]) > still), None)


def _comes_to_rest(v: Sequence[float], cart: int) -> bool:
    """Whether a cart that moved before the contact stands still after it."""
    return abs(v[cart + 2]) < AT_REST * max(map(abs, v)) < abs(v[cart])


def check_seen(speeds: Speeds, names: tuple[str, str]) -> None:
    """Of two sensors: raises FitError where a standing cart may as well be one that is not seen."""
    v, lost = speeds.v, perhaps_lost(speeds)
    if lost is not None and (v[3] - v[2]) / (v[0] - v[1]) < ELASTIC:
        raise FitError(
            said(
                "{cart} comes, and after the contact its readings stand still while the other cart "
                "moves on: it may have stopped, or its sensor has lost it while both move on "
                "together. These readings do not tell which",
                cart=names[lost],
            ),
            SAY_TOGETHER,
            "perhaps-lost",
        )
