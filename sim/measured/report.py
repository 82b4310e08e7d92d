"""Readings to a report: what was read, what it tells, what it does not. Plain values."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from sim.measured.as_scene import fence, remarks, scene_lines, scene_text
from sim.measured.as_tracker import tracker_text
from sim.measured.events.quantities import with_loss
from sim.measured.model.believable import believable
from sim.measured.model.effects import Compared, called_for, neighbours, rms_residual
from sim.measured.model.fit import Fit
from sim.measured.model.known import quantities_of_fit
from sim.measured.model.lasting import smoothed
from sim.measured.model.motion import Motion
from sim.measured.model.quantity import Known, Untold
from sim.measured.third_law import SensorComparison
from sim.measured.tracks import Measured
from sim.measured.words.effects import of_effects
from sim.measured.words.fit import LAWS, of_balance, of_fit, of_interval, of_loss
from sim.measured.words.forces import of_pair
from sim.measured.words.phones import of_clocks, of_phones
from sim.scene.said import said

FORMAT = 1
FENCE_ID = "our-own-carts"


def motion_report(
    measured: Measured,
    fit: Fit,
    compared: Sequence[Compared] = (),
    masses: Mapping[str, float] | None = None,
    share: float = 0.0,
) -> dict[str, Any]:
    """Everything that a fit says. `masses`: by name, in kg, of the carts that were weighed;
    `share` of the push that friction may have taken in the contact."""
    masses = masses or {}
    names = measured.names
    mass = next(iter(masses.items()), None)
    known, untold = believable(
        *quantities_of_fit(fit, names, mass, smoothed(measured, neighbours(fit)))
    )
    judged = [
        with_loss(one, share) if share and one.key in ("mass_ratio", "mass") else one
        for one in known
    ]
    known = [one for one in judged if isinstance(one, Known)]
    untold += [one for one in judged if isinstance(one, Untold)]
    ratio = next((one for one in known if one.key == "mass_ratio"), None)
    sentences = [
        *of_effects(compared, names),
        *of_loss(share if ratio else 0.0),
        *of_fit(fit, names, compared, synthetic=measured.synthetic),
    ]
    if balance := of_balance(ratio, masses, names, synthetic=measured.synthetic):
        sentences.insert(0, balance)
    first, last = span(measured)
    lines, notes = scene_lines(fit, names, (first, last), mass), remarks(fit, mass)
    return {
        "format": FORMAT,
        "kind": "motion",
        "names": list(names),
        "read": list(measured.notes),
        "readings": [len(track.t) for track in measured.tracks],
        "law": fit.asked.law,
        "law_words": LAWS[fit.asked.law],
        "effect": fit.asked.effect,
        "known": [row_of(one) for one in known],
        "untold": [{"key": o.key, "name": o.name, "reason": o.reason} for o in untold],
        "noise": fit.noise,
        "compared": [
            {
                "effect": row.effect,
                "noise": row.noise,
                "rms": rms_residual(row.fit),
                "chance": row.chance,
                "neighbours": row.alike,
            }
            for row in compared
        ],
        "calls_for": called_for(list(compared)) if compared else None,
        "sentences": sentences,
        "scene": scene_text(lines, notes),
        "fence": fence(lines, FENCE_ID, notes),
    }


def row_of(one: Known) -> dict[str, Any]:
    """A quantity as plain values."""
    interval = of_interval(one)
    return {
        "key": one.key,
        "name": one.name,
        "value": one.value,
        "low": _finite(one.low),
        "high": _finite(one.high),
        "sd": _finite(one.sd),
        "unit": one.unit,
        "interval": interval,
        "text": said("{name}: {interval}", name=one.name, interval=interval),
        **({"alone": list(one.alone)} if one.alone else {}),
    }


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def span(measured: Measured) -> tuple[float, float]:
    """s. First and last reading of either."""
    return min(t.t[0] for t in measured.tracks), max(t.t[-1] for t in measured.tracks)


def forces_report(measured: Measured, pair: SensorComparison) -> dict[str, Any]:
    """What two force sensors or two phones say."""
    phones = measured.kind == "acceleration"
    words = of_phones if phones else of_pair
    sentences = words(pair, measured.names, synthetic=measured.synthetic)
    sentences += [of_clocks(pair.set)] if pair.set is not None else []
    return {
        "format": FORMAT,
        "kind": "accelerations" if measured.kind == "acceleration" else "forces",
        "names": list(measured.names),
        "read": list(measured.notes),
        "readings": [len(track.t) for track in measured.tracks],
        "ratio": pair.ratio,
        "ratio_half": pair.ratio_half,
        "impulses": list(pair.impulses),
        "impulse_sd": list(pair.impulse_sd),
        "peaks": list(pair.peaks),
        "zeros": list(pair.zeros),
        "noise": list(pair.noise),
        "lag": pair.lag,
        "set": pair.set,
        "sentences": sentences,
    }


def model_as_tracker(measured: Measured, fit: Fit) -> str:
    """The fitted motion at the times of the readings, as Tracker exports it."""
    times = sorted({t for track in measured.tracks for t in track.t})
    motion = Motion(fit.parameters, fit.asked.law)
    states = [motion.state(t)[0] for t in times]
    return tracker_text(measured.names, times, [[row[k] for row in states] for k in range(2)])
