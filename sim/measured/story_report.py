"""What happened as plain values: by the whole model, by the velocities alone, or refused."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from sim.measured.events.momentum import Momentum, momentum_of
from sim.measured.events.quantities import loss, quantities_of_outcome
from sim.measured.events.story import Story
from sim.measured.events.wild import of_aside
from sim.measured.events.words import as_sure, of_momentum, of_rung, of_scatter, of_story, of_taken
from sim.measured.model.believable import believable
from sim.measured.model.effects import Compared
from sim.measured.model.fit import Fit
from sim.measured.model.known import LASTS, STIFFNESS, SWING
from sim.measured.model.quantity import Untold
from sim.measured.refusal import FitError
from sim.measured.report import FORMAT, motion_report, row_of
from sim.measured.same_ratio import two_sensors
from sim.measured.tracks import Measured
from sim.measured.words.fit import LAWS, of_balance, of_law
from sim.scene.said import said

Masses = Mapping[str, float]
"""kg, by the name of the cart."""

NOT_WHITE = said(
    "the model of one bumper leaves residuals that are not random, so it does not tell this: "
    "friction, a tilt, a second push or the device's own smoothing is in them"
)


def by_model(
    measured: Measured, story: Story, made: Fit, rows: list[Compared], masses: Masses, every: bool
) -> dict[str, Any]:
    """The report of the whole model, with what happened beside it."""
    asked = {row.effect: row for row in rows}
    kept = (
        rows if every else [asked["none"], *(r for r in rows if r.effect == made.asked.effect)][:2]
    )
    if len(kept) == 2 and kept[0] is kept[1]:
        kept = kept[:1]
    report = motion_report(story.measured, made, kept, masses, _share(made, story))
    base = base_report(measured, story, "bounce", None)
    happened = as_sure(base["sentences"], report["known"])
    sentences = [*happened, *_momentum_said(story, masses), *report["sentences"]]
    return base | report | {
        "outcome": "bounce", "momentum": _momentum(story, masses), "sentences": sentences,
        "readings": base["readings"],
    }  # fmt: skip


def _share(made: Fit, story: Story) -> float:
    """Of the push: what friction in the contact may take beside what the model knows."""
    (a, b), q, e = made.parameters.v, made.parameters.ratio, min(made.parameters.e, 1.0)
    middle, push = (a + q * b) / (1.0 + q), e * (a - b) / (1.0 + q)
    return loss((a, b, middle - q * push, middle + push), story.step, "bounce")


def by_velocities(
    measured: Measured, story: Story, made: Fit | None, rows: list[Compared], masses: Masses
) -> dict[str, Any]:
    """The report of the velocities beside the contact."""
    assert story.outcome and story.speeds and story.contact and story.step
    names = measured.names
    known, untold = believable(*quantities_of_outcome(
        story.outcome, story.speeds, story.contact, story.step, names, masses,
        two_sensors(story), story.together,
    ))  # fmt: skip
    base = base_report(measured, story, story.outcome, None)
    ratio = next((one for one in known if one.key == "mass_ratio"), None)
    told = [row_of(one) for one in known]
    sentences = [*as_sure(base["sentences"], told), *_momentum_said(story, masses)]
    if balance := of_balance(ratio, masses, names, synthetic=measured.synthetic):
        sentences.append(balance)
    model: dict[str, Any] = {}
    if made is not None:
        by_key = {one.key: one for one in known}
        better = replace(made, parameters=replace(
            made.parameters,
            e=by_key["e"].value if "e" in by_key else min(max(made.parameters.e, 0.0), 1.0),
            ratio=by_key["mass_ratio"].value if "mass_ratio" in by_key else made.parameters.ratio,
        ))  # fmt: skip
        model = motion_report(story.measured, better, rows, masses)
        untold += [
            Untold(key, name, NOT_WHITE)
            for key, name in (("duration", LASTS), ("w0", SWING), ("k", STIFFNESS))
        ]  # fmt: skip
    kept = {key: model[key] for key in _FROM_MODEL if key in model}
    return base | kept | {
        "known": told,
        "untold": [{"key": o.key, "name": o.name, "reason": o.reason} for o in untold],
        "momentum": _momentum(story, masses),
        "sentences": [*sentences, of_law(synthetic=measured.synthetic)],
    }  # fmt: skip


_FROM_MODEL = ("effect", "noise", "compared", "calls_for", "scene", "fence")


def base_report(
    measured: Measured, story: Story, outcome: str | None, refused: FitError | None
) -> dict[str, Any]:
    """What every report has, refused or not."""
    names = measured.names
    frames = story.frames
    axes = frames.axes if frames else None
    base: dict[str, Any] = {
        "format": FORMAT,
        "kind": "motion",
        "outcome": outcome,
        "names": list(names),
        "read": list(measured.notes),
        "readings": [len(track.t) for track in measured.tracks],
        "sensors": {
            name: {"sign": axes[k].sign if axes else 1, "zero": axes[k].zero if axes else 0.0}
            for k, name in enumerate(names)
        },
        "segments": segment_rows(story),
        "contacts": [
            {"from": c.begin, "until": c.end, "at": c.middle, "chosen": c == story.contact}
            for c in story.contacts
        ],
        "ladder": [
            {"step": step, "held_out": error, "taken": step == story.speeds.step}
            for step, error in story.speeds.held_out
        ] if story.speeds else [],
        "rungs": _rungs(story),
        "law": "bumper", "law_words": LINES if outcome else LAWS["bumper"], "effect": "none",
        "known": [], "untold": [], "noise": None, "compared": [], "calls_for": None,
        "aside": [{"cart": names[o.cart], "t": o.t, "x": o.value} for o in story.aside],
        "momentum": None, "scene": "", "fence": "", "added": "", "doubt": "",
        "sentences": [*of_aside(story.aside, names), *of_story(story, names)],
    }  # fmt: skip
    if refused:
        base["refused"] = {"code": refused.code, "sentence": refused.reason, "hint": refused.hint}
    return base


def segment_rows(story: Story) -> list[dict[str, Any]]:
    """What each cart did, and when (s)."""
    names = story.measured.names
    return [
        {"from": s.begin, "until": s.end, "cart": names[s.cart], "kind": s.kind}
        for s in story.segments
    ]


def _rungs(story: Story) -> dict[str, Any] | None:
    """What each effect changes beside the contact, largest first, and what readings can show."""
    speeds = story.speeds
    if speeds is None or story.outcome is None:
        return None
    rows = [
        {
            "effect": rung.step,
            "changes": rung.changes,
            "missed": rung.missed,
            "without": rung.without,
            "verdict": rung.verdict,
            "sentence": of_rung(rung),
        }
        for rung in speeds.rungs
    ]
    told = {"line": of_scatter(speeds), "taken": of_taken(speeds)}
    return {"scatter": speeds.scatter, **told, "rows": rows}


LINES = said("straight lines beside the contact, bent by what brakes the carts")


def _balance(story: Story, masses: Masses) -> Momentum | None:
    names = story.measured.names
    if len(masses) < 2 or not (story.speeds and story.step and story.outcome):
        return None
    both = masses[names[0]], masses[names[1]]
    return momentum_of(story.speeds, both, story.step, story.outcome)


def _momentum(story: Story, masses: Masses) -> dict[str, Any] | None:
    found = _balance(story, masses)
    if found is None:
        return None
    return {
        "before": found.before, "before_half": found.before_half,
        "after": found.after, "after_half": found.after_half,
        "change": found.change, "change_half": found.change_half,
        "friction": found.friction, "agree": found.agree,
    }  # fmt: skip


def _momentum_said(story: Story, masses: Masses) -> list[str]:
    found = _balance(story, masses)
    return [of_momentum(found)] if found else []
