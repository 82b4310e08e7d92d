"""What a run of the engine comes to, beside an oracle that shares no code with it.

A run has `BUDGET` seconds of processor time (a virtual timer: other programs do not count). The
oracle is the integration of `tests.reference`, with a budget of its own. Where both end, they are
to agree within what the same run makes of inputs moved in the last figures.
"""

from __future__ import annotations

import math
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

from sim.dynamics.loop.run import run
from sim.dynamics.result.outcome import UnsolvedError
from sim.scene import SceneError, read_scene
from tests.fuzz.mirror import mirrored
from tests.fuzz.rows import Plain
from tests.fuzz.units import scaled
from tests.processor_time import TooSlowError, budget
from tests.reference.contact_branches import DEAD, UnsupportedError
from tests.reference.effects import integrate

BUDGET = 1.0
"""s of processor time for one run."""

ORACLE_BUDGET = 4.0
"""s. The integration takes a hundred times as long as the run."""

AGREE = 1e-8
"""Of the greatest speed and way. The integration is good to 1e-10 or so; its signs to 1e-13 m."""

TURNED = 1e-11
"""The same, of a run and that of the mirrored scene."""

ROUGH = 1e-6
"""The same. Up to here it may be the integration: it is done once more, with finer steps."""

FINE_BUDGET = 30.0
"""s."""

MOVED = 1e-12
"""Relative. The inputs of the run that tells how well the scene is conditioned."""

CLOSES = 1e-10
"""Of all energies in play."""

MOST_CHANGES = 400
"""Changes of formula up to which the oracle follows."""


@dataclass(frozen=True)
class Verdict:
    """One word, and what is behind it.

    right · unknown (no oracle) · refused · no scene · crash · slow · many · account · end · mirror
    scale: in other units, powers of 2, it is not the same run to the last bit
    """

    word: str
    detail: str = ""


GOOD = ("right", "unknown", "refused", "no scene")


def judge(plain: Plain, *, oracle: bool = True, seconds: float = BUDGET) -> Verdict:
    """Run the scene, and look at what comes out."""
    try:
        scene = read_scene(plain)
    except SceneError as error:
        return Verdict("no scene", str(error)[:200])
    try:
        with budget(seconds):
            done = run(scene)
    except TooSlowError:
        return Verdict("slow")
    except UnsolvedError as error:
        return Verdict("refused", error.message)
    except Exception as error:
        return Verdict("crash", f"{type(error).__name__}: {error}")
    if done.stopped is not None:
        return Verdict("many", str(done.stopped))
    imbalance = done.ledger.imbalance()
    if imbalance > CLOSES:
        return Verdict("account", f"energy open by {imbalance:.1e}")
    return compared(plain, done) if oracle else Verdict("unknown")


def compared(plain: Plain, done: Any) -> Verdict:
    """The end state beside that in a mirror and the oracle's.

    In the units of a tabletop, where the scene has others.
    """
    if (turned := in_a_mirror(plain, done)) is not None:
        return turned
    units = units_of(plain)
    if units != (1.0, 1.0, 1.0):
        m, length, s = units
        plain = scaled(plain, 1.0 / m, 1.0 / length, 1.0 / s)
        try:
            with budget(BUDGET):
                other = run(read_scene(plain))
        except (SceneError, UnsolvedError, TooSlowError) as error:
            return Verdict("unknown", f"in other units: {error}")
        if tuple(v * length / s for v in other.v) != done.v:
            return Verdict("scale", f"{done.v} for {tuple(v * length / s for v in other.v)}")
        done = other
    if (dead := as_nothing_back(plain)) != plain:
        plain, done = dead, run(read_scene(dead))
    try:
        with budget(ORACLE_BUDGET):
            expected = integrate(done.scene, most_steps=20_000)
    except (UnsupportedError, TooSlowError, ArithmeticError, ValueError) as error:
        return Verdict("unknown", str(error) or "the oracle needs too long")
    if expected.changes > MOST_CHANGES:
        return Verdict("unknown", "too many changes to follow")
    off = distance(done, expected.x, expected.v)
    if off <= AGREE:
        return Verdict("right", f"{off:.1e}")
    if off <= 100.0 * conditioning(plain, done):
        return Verdict("right", f"{off:.1e}, ill conditioned")
    if off <= ROUGH:
        try:
            with budget(FINE_BUDGET):
                expected = integrate(done.scene, most_steps=100_000, fine=True)
        except (UnsupportedError, TooSlowError, ArithmeticError, ValueError):
            return Verdict("end", f"off by {off:.1e}, and no finer oracle in time")
        if (off := distance(done, expected.x, expected.v)) <= AGREE:
            return Verdict("right", f"{off:.1e}, finely")
    return Verdict("end", f"off by {off:.1e}: {done.v} for {tuple(map(float, expected.v))}")


def as_nothing_back(plain: Plain) -> Plain:
    """The scene as the oracle has it: a bumper that gives back less than `DEAD` gives nothing.

    What such a pair parts by, e u, is small; but the root of the room that it opens tells when the
    two touch again under a force.
    """

    def one(contact: Plain) -> Plain:
        own = dict(contact)
        if 0.0 < float(own.get("restitution", 1.0)) <= DEAD:
            own["restitution"] = 0
        return own

    contact = one(plain.get("contact", {}))
    if "pairs" in contact:
        contact["pairs"] = {name: one(own) for name, own in contact["pairs"].items()}
    return {**plain, "contact": contact}


def in_a_mirror(plain: Plain, done: Any) -> Verdict | None:
    """Does the scene with left and right exchanged end otherwise?"""
    try:
        with budget(BUDGET):
            other = run(read_scene(mirrored(plain)))
    except TooSlowError:
        return None
    length = float(plain["track"]["length"])
    x, v = [length - x for x in reversed(other.x)], [-v for v in reversed(other.v)]
    off = distance(done, x, v)
    if off <= TURNED or off <= 100.0 * conditioning(plain, done):
        return None
    return Verdict("mirror", f"off by {off:.1e}: {done.v} for {tuple(v)}")


def units_of(plain: Plain) -> tuple[float, float, float]:
    """kg, m, s, powers of 2 in which the scene is one of a tabletop; 1 where it is one."""
    carts = list(plain["carts"].values())
    length = max(float(cart.get("length", 0.2)) for cart in carts) / 0.2
    mass = max(float(cart["mass"]) for cart in carts)
    gravity = float(plain.get("gravity", 9.81)) / 9.81
    powers = [math.log2(one) for one in (mass, length, math.sqrt(length / gravity))]
    m, metre, s = (2.0 ** (5 * round(p / 5)) for p in powers)
    return m, metre, s


def distance(done: Any, x: Any, v: Any) -> float:
    """Of velocities and places, each relative to the greatest in the run."""
    told = [abs(v) for e in done.record.events for v in (*e.before.values(), *e.after.values())]
    begun = [abs(cart.velocity) for cart in done.scene.carts]
    length = max(abs(c.position) + c.length for c in done.scene.carts)
    fastest = max(*map(abs, done.v), *begun, *told, 1e-3 * length / done.t)
    way = max(fastest * done.t, length)
    faster = max([fastest, *map(abs, v)])
    apart = max(abs(a - b) for a, b in zip(done.v, v, strict=True)) / faster
    return max(apart, max(abs(a - b) for a, b in zip(done.x, x, strict=True)) / way)


def conditioning(plain: Plain, done: Any) -> float:
    """How far the end moves when speeds and stiffness move by `MOVED`."""
    worst = 0.0
    for sign in (1.0, -1.0):
        moved = deepcopy(plain)
        for k, cart in enumerate(moved["carts"].values()):
            cart["velocity"] = float(cart.get("velocity", 0.0)) * (1.0 + sign * (k + 1) * MOVED)
            cart["mass"] = float(cart["mass"]) * (1.0 - sign * (k + 1) * MOVED)
        try:
            with budget(BUDGET):
                other = run(read_scene(moved))
        except (SceneError, UnsolvedError, TooSlowError):
            return 1.0
        worst = max(worst, distance(done, other.x, other.v))
    return worst
