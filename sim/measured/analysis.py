"""One recording to one report: what happened, the fit that can be believed, or why there is none.

The velocities beside the contact give every outcome's quantities (sim.measured.events). For a
bounce the whole model is fitted too. Where its residuals are white, it is the sharper instrument,
and its numbers are told; where they are not, its intervals would be too narrow, and those of the
velocities stand. A scene comes from the model in both cases.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from sim.measured.believable import believable
from sim.measured.contact import Law
from sim.measured.effects import ALIKE, Compared, called_for, compare, neighbours
from sim.measured.events.momentum import Momentum, momentum_of
from sim.measured.events.outcome import PERHAPS
from sim.measured.events.quantities import mass_ratio, told_of
from sim.measured.events.sides import window
from sim.measured.events.story import Hints, Story, story_of
from sim.measured.events.words import of_momentum, of_story
from sim.measured.fit import EFFECTS, Asked, Effect, Fit, fit
from sim.measured.known import Untold
from sim.measured.refusal import FitError, ReadingError
from sim.measured.report import FORMAT, motion_report, row_of
from sim.measured.tracks import Measured, between
from sim.measured.words import LAWS, PROGRAM, of_balance

MOST_FITTED = 700
"""Readings of a cart that the whole model is fitted to; of more, every second or third is taken."""

MOST_SKETCHED = 120
"""The same where only a scene comes of it."""

ROUNDING = 1e-6
"""Noise as a share of the range below which residuals are rounding, and alike without harm."""

DOUBTFUL = ("no-contact", "before-too-short", "after-too-short", "no-change", "no-fit",
            "not-in-step", "lost-after")  # fmt: skip
"""Refusals that the whole model may overrule in one frame, if it leaves white residuals."""

NOT_WHITE = (
    "the model of one bumper leaves residuals that are not random, so it does not tell this: "
    "friction, a tilt, a second push or the device's own smoothing is in them"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """How to look. `effect`: None takes what the readings call for; `masses` in kg by name."""

    law: Law = "bumper"
    effect: Effect | None = None
    every: bool = True  # compare all effects
    masses: Mapping[str, float] = field(default_factory=dict)
    hints: Hints = field(default_factory=Hints)


@dataclass(frozen=True, slots=True)
class Analysis:
    """`report` is plain values; `refused` where no fit is given; `fit`: of the whole model."""

    story: Story
    report: dict[str, Any]
    fit: Fit | None = None
    refused: FitError | None = None


def analysed(measured: Measured, wanted: Wanted = Wanted()) -> Analysis:
    """The report of two carts; never raises FitError."""
    story = story_of(measured, wanted.hints)
    refused, rows = story.refused, list[Compared]()
    overruled = refused is not None and refused.code in DOUBTFUL and not measured.own
    if story.outcome == "bounce" or overruled:
        try:
            rows = _whole_model(story, wanted)
        except (FitError, ReadingError) as error:
            if refused and isinstance(error, FitError) and refused.code in ("no-contact", "no-fit"):
                refused = FitError(error.reason, error.hint, refused.code)
            rows = []
    made = _chosen(rows, wanted) if rows else None
    white = made is not None and any(_white(row.fit, story) for row in rows)
    bounces = made is not None and PERHAPS < made.parameters.e <= 1.02
    if refused and not (overruled and white and bounces):
        return Analysis(story, _base(measured, story, None, refused), None, refused)
    if made is not None and white and (refused or _same(story, made, wanted)):
        report = _by_model(measured, story, made, rows, wanted)
    else:
        report = _by_velocities(measured, story, made, rows, wanted)
    return Analysis(story, report, made)


def _whole_model(story: Story, wanted: Wanted) -> list[Compared]:
    """The model with the effects that are asked for; more only if none leaves white residuals."""
    smooth = _smooth(story)
    cut = _thinned(_free(story), MOST_SKETCHED if smooth else MOST_FITTED)
    plain = fit(cut, Asked(law=wanted.law, distance=wanted.hints.distance))
    if smooth:  # for the scene alone
        return compare(cut, plain, [])
    effects = [one for one in EFFECTS if one != "none"]
    if wanted.every or wanted.effect is None:
        return compare(cut, plain, effects)
    rows = compare(cut, plain, [one for one in effects if one == wanted.effect])
    if not any(_white(row.fit, story) for row in rows):
        rows += compare(cut, plain, [one for one in effects if one != wanted.effect])[1:]
    return rows


def _free(story: Story) -> Measured:
    """The readings around the contact in which nobody holds a cart."""
    if story.contact is None:
        return story.measured
    low, high = float("-inf"), float("inf")
    for cart in (0, 1):
        named = [one for one in story.segments if one.cart == cart]
        low = max(low, window(story.contact, named, False, float("inf"))[0])
        high = min(high, window(story.contact, named, True, float("inf"))[1])
    ends = [one.end for one in story.segments]
    begins = [one.begin for one in story.segments]
    # A span that reaches the first or last segment reaches all readings.
    first = None if not begins or low <= min(begins) + 1e-9 else low
    last = None if not ends or high >= max(ends) - 1e-9 else high
    return between(story.measured, first, last)


def _smooth(story: Story) -> bool:
    """Whether a device read so often that its readings are alike, model or not."""
    often = max(len(track.t) for track in story.measured.tracks) > MOST_FITTED
    return often and story.speeds is not None and story.speeds.alike > ALIKE


def _thinned(measured: Measured, readings: int) -> Measured:
    most = max(len(track.t) for track in measured.tracks)
    k = -(-most // readings)
    if k == 1:
        return measured
    tracks = [
        replace(one, t=one.t[::k], value=one.value[::k], lines=one.lines[::k])
        for one in measured.tracks
    ]
    return replace(measured, tracks=(tracks[0], tracks[1]))


def _chosen(rows: list[Compared], wanted: Wanted) -> Fit | None:
    effect = called_for(rows) if wanted.effect is None else wanted.effect
    return next((row.fit for row in rows if row.effect == effect), rows[0].fit)


def _white(made: Fit, story: Story) -> bool:
    """Whether the residuals are chance, or nothing but rounding."""
    reach = max(max(track.value) - min(track.value) for track in story.measured.tracks)
    if made.noise < ROUNDING * reach:
        return True
    return neighbours(made) <= ALIKE and not _smooth(story)


def _same(story: Story, made: Fit, wanted: Wanted) -> bool:
    """Whether the model's mass ratio lies in the interval of the velocities; else white residuals
    deceive. An effect that the reader asks for is the reader's to judge."""
    if story.frames is not None and story.frames.joined:
        return False  # one model of both places cannot know that two sensors have two scales
    if wanted.effect is not None or not (story.outcome and story.speeds and story.step):
        return True
    ratio = mass_ratio(story.speeds, story.step, story.outcome, story.measured.names)
    if isinstance(ratio, Untold):
        return True
    half = made.factor * made.sd("ln_ratio")
    low, high = math.log(ratio.low) - half, math.log(ratio.high) + half
    return low <= math.log(made.parameters.ratio) <= high


def _by_model(
    measured: Measured, story: Story, made: Fit, rows: list[Compared], wanted: Wanted
) -> dict[str, Any]:
    """The report of the whole model, with what happened beside it."""
    asked = {row.effect: row for row in rows}
    kept = rows if wanted.every else [asked["none"], *(r for r in rows if r.fit is made)][:2]
    if len(kept) == 2 and kept[0] is kept[1]:
        kept = kept[:1]
    report = motion_report(story.measured, made, kept, wanted.masses)
    base = _base(measured, story, "bounce", None)
    sentences = [*base["sentences"], *_momentum_said(story, wanted), *report["sentences"]]
    return base | report | {
        "outcome": "bounce", "momentum": _momentum(story, wanted), "sentences": sentences,
        "readings": base["readings"],
    }  # fmt: skip


def _by_velocities(
    measured: Measured, story: Story, made: Fit | None, rows: list[Compared], wanted: Wanted
) -> dict[str, Any]:
    """The report of the velocities beside the contact."""
    assert story.outcome and story.speeds and story.contact and story.step and story.frames
    names, masses = measured.names, wanted.masses
    known, untold = believable(*told_of(
        story.outcome, story.speeds, story.contact, story.step, names, masses,
        story.frames.joined,
    ))  # fmt: skip
    base = _base(measured, story, story.outcome, None)
    ratio = next((one for one in known if one.key == "mass_ratio"), None)
    said = [*base["sentences"], *_momentum_said(story, wanted)]
    said += [of_balance(ratio, masses, names)] if len(masses) == 2 and ratio else []
    model: dict[str, Any] = {}
    if made is not None:
        told = {one.key: one for one in known}
        better = replace(made, parameters=replace(
            made.parameters,
            e=told["e"].value if "e" in told else min(max(made.parameters.e, 0.0), 1.0),
            ratio=told["mass_ratio"].value if "mass_ratio" in told else made.parameters.ratio,
        ))  # fmt: skip
        model = motion_report(story.measured, better, rows, masses)
        untold += [
            Untold(key, name, NOT_WHITE)
            for key, name in (("duration", "the contact lasts"), ("w0", "√(k/μ)"),
                              ("k", "stiffness k in N/m"))
        ]  # fmt: skip
    kept = {key: model[key] for key in _FROM_MODEL if key in model}
    return base | kept | {
        "known": [row_of(one) for one in known],
        "untold": [{"key": o.key, "name": o.name, "reason": o.reason} for o in untold],
        "momentum": _momentum(story, wanted),
        "sentences": [*said, PROGRAM],
    }  # fmt: skip


_FROM_MODEL = ("effect", "noise", "compared", "calls_for", "scene", "fence")


def _base(
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
        "segments": [
            {"from": s.begin, "until": s.end, "cart": names[s.cart], "kind": s.kind}
            for s in story.segments
        ],
        "contacts": [
            {"from": c.begin, "until": c.end, "at": c.middle, "chosen": c == story.contact}
            for c in story.contacts
        ],
        "ladder": [
            {"step": step, "held_out": error, "taken": step == story.speeds.step}
            for step, error in story.speeds.held_out
        ] if story.speeds else [],
        "law": "bumper", "law_words": _WORDS.get(outcome or "", LAWS["bumper"]), "effect": "none",
        "known": [], "untold": [], "noise": None, "compared": [], "calls_for": None,
        "momentum": None, "sentences": of_story(story, names), "scene": "", "fence": "",
    }  # fmt: skip
    if refused:
        base["refused"] = {"code": refused.code, "sentence": refused.reason, "hint": refused.hint}
    return base


_WORDS = {
    "bounce": "straight lines beside the contact, bent by what brakes the carts",
    "stick": "straight lines beside the contact, bent by what brakes the carts",
    "explosion": "straight lines beside the contact, bent by what brakes the carts",
}


def _balance(story: Story, wanted: Wanted) -> Momentum | None:
    names, masses = story.measured.names, wanted.masses
    if len(masses) < 2 or not (story.speeds and story.step and story.outcome):
        return None
    both = masses[names[0]], masses[names[1]]
    return momentum_of(story.speeds, both, story.step, story.outcome)


def _momentum(story: Story, wanted: Wanted) -> dict[str, Any] | None:
    found = _balance(story, wanted)
    if found is None:
        return None
    return {
        "before": found.before, "before_half": found.before_half,
        "after": found.after, "after_half": found.after_half,
        "change": found.change, "change_half": found.change_half,
        "friction": found.friction, "agree": found.agree,
    }  # fmt: skip


def _momentum_said(story: Story, wanted: Wanted) -> list[str]:
    found = _balance(story, wanted)
    return [of_momentum(found)] if found else []
