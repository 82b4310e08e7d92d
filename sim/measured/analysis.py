"""One recording to one report: what happened, the fit that can be believed, or why there is none.

The velocities beside the contact give every outcome's quantities (sim.measured.events). For a
bounce the whole model is fitted too. Where its residuals are white, or alike for a few readings
only, it is the sharper instrument, and its numbers are told; where they are alike for long, or
alike in spite of a brake that was fitted, its intervals would be too narrow, and those of the
velocities stand. A scene comes from the model in both cases.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from sim.measured.events.outcome import PERHAPS
from sim.measured.events.quantities import quantities_of_outcome
from sim.measured.events.sides import window
from sim.measured.events.story import Hints, Story, story_of
from sim.measured.events.stretch import Segment
from sim.measured.events.wild import without_wild
from sim.measured.model.averaged import averaged
from sim.measured.model.brake_doubt import another_push, doubted, form_told
from sim.measured.model.contact import Law
from sim.measured.model.effects import ALIKE, Compared, called_for, compare, neighbours
from sim.measured.model.fit import Asked, Fit, fit
from sim.measured.model.instant import perhaps_instant
from sim.measured.model.unknowns import EFFECTS, RUBS, Effect
from sim.measured.model.unseen_length import of_any_length
from sim.measured.refusal import FitError, ReadingError
from sim.measured.same_ratio import same_ratio, two_sensors
from sim.measured.story_report import base_report, by_model, by_velocities
from sim.measured.tracks import Measured, between
from sim.measured.words.effects import head_of

MOST_FITTED = 700
"""Readings of a cart that the whole model is fitted to; of more, every second or third is taken."""

MOST_SKETCHED = 120
"""The same where only a scene comes of it."""

LASTING = 0.8
"""Correlation of neighbouring residuals up to which the model's own intervals count what noise that
lasts does to them (sim.measured.model.coloured). Above it a film holds too few that are apart."""

ROUNDING = 1e-6
"""Noise as a share of the range below which residuals are rounding, and alike without harm."""

TURN = 0.01
"""Of the approach: the velocity at which a cart may or may not turn round in the contact."""

CHANGED = 0.25
"""Standard deviation of ln(mass ratio). It is that of both velocities' changes, as shares of them:
where it is larger, one change is no more than four times its noise, and no contact is shown."""

DOUBTFUL = ("no-contact", "before-too-short", "after-too-short", "no-change", "no-fit",
            "not-in-step", "lost-after")  # fmt: skip
"""Refusals that the whole model may overrule in one frame, if it leaves white residuals."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """How to look. `effect`: None takes what the readings call for; `masses` in kg by name."""

    law: Law = "bumper"
    effect: Effect | None = None
    every: bool = True  # tell of all effects, and name them
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
    story = happened(measured, wanted.hints)
    refused, rows = story.refused, list[Compared]()
    overruled = refused is not None and refused.code in DOUBTFUL and not two_sensors(story)
    if story.outcome == "bounce" or overruled:
        try:
            rows = _whole_model(story, wanted)
        except (FitError, ReadingError) as error:
            if refused and refused.code == "no-fit":
                refused = _plainer(refused, error)
            rows = []
    made = _chosen(rows, wanted) if rows else None
    if made is not None and not made.parameters.approach > 0.0:
        made = None  # both stand still before the touch: nothing bounces
    if made is not None and wanted.effect is None and _at_the_turn(made):
        made = None
    white = made is not None and any(_white(row.fit, story) for row in rows)
    white = white and (wanted.effect is not None or _brake_right(made))
    bounces = made is not None and _bounces(made)
    if refused and not (overruled and white and bounces):
        return Analysis(story, base_report(measured, story, None, refused), None, refused)
    if made is not None and white and (refused or same_ratio(story, made, wanted.effect)):
        made = _doubted(story, made, rows, wanted)
        report = by_model(measured, story, made, rows, wanted.masses, wanted.every)
        effect = made.asked.effect
        report |= head_of(effect, rows, wanted.effect, named=wanted.every)
    else:
        report = by_velocities(measured, story, made, rows, wanted.masses)
    return Analysis(story, report, made)


def _plainer(refused: FitError, error: FitError | ReadingError) -> FitError:
    """Why the model could not be fitted, if that says more. Not of carts that were never seen to
    push each other: the model takes a contact for granted."""
    if isinstance(error, ReadingError) or error.code == "no-contact":
        return refused
    return FitError(error.reason, error.hint, refused.code)


def happened(measured: Measured, hints: Hints) -> Story:
    """What happened, without any fit of the model: quick, and never raises FitError."""
    calm, aside = without_wild(measured)
    return replace(story_of(calm, hints), aside=aside)


def _doubted(story: Story, made: Fit, rows: list[Compared], wanted: Wanted) -> Fit:
    """The model, no surer than its effect and the velocities; the reader's is theirs to judge."""
    if wanted.effect is not None:
        return made
    fitted = _thinned(_free(story), MOST_FITTED)
    made = averaged(perhaps_instant(made, fitted), rows)
    effect, speeds = made.asked.effect, story.speeds
    if effect == "none" or not (story.outcome and speeds and story.contact and story.step):
        return made
    names = story.measured.names
    seen, _ = quantities_of_outcome(
        story.outcome, speeds, story.contact, story.step, names, beside=story.together
    )
    told = speeds.even and form_told(effect, speeds.held_out) and not another_push(made, fitted)
    return doubted(made, seen, told=told)


def _bounces(made: Fit) -> bool:
    """Whether both carts clearly changed their velocities, and the model's e is clearly more than
    that of a stick, and can be 1 or less."""
    e = made.parameters.e
    return made.sd("ln_ratio") < CHANGED and e > PERHAPS and e - made.factor * made.sd("e") <= 1.0


def _whole_model(story: Story, wanted: Wanted) -> list[Compared]:
    """The model without and with each effect: which one is missing is told, whichever was asked
    for."""
    smooth = _smooth(story)
    cut = _thinned(_free(story), MOST_SKETCHED if smooth else MOST_FITTED)
    plain = fit(cut, Asked(law=wanted.law, distance=wanted.hints.distance))
    # of smooth readings the model is for the scene alone
    if smooth:
        return compare(cut, plain, (), wanted.effect)
    return of_any_length(compare(cut, plain, EFFECTS[1:], wanted.effect), cut)


def _free(story: Story) -> Measured:
    """The readings around the contact in which nobody holds a cart, and each cart's own until it
    has come to rest: where it rests at last, real friction does not let it rest as a model does."""
    if story.contact is None:
        return story.measured
    spans = []
    for rested in (True, False):
        for cart in (0, 1):
            named = [one for one in story.segments if one.cart == cart]
            first = window(story.contact, named, False, float("inf"), rested)[0]
            last = window(story.contact, named, True, float("inf"), rested)[1]
            spans.append(_opened(named, first, last))
    low, high = max(spans[0][0], spans[1][0]), min(spans[0][1], spans[1][1])
    own = (
        between(story.measured, max(low, one[0]), min(high, one[1])).tracks[cart]
        for cart, one in enumerate(spans[2:])
    )
    return replace(story.measured, tracks=(next(own), next(own)))


def _opened(named: list[Segment], low: float, high: float) -> tuple[float, float]:
    """A span that reaches the first or the last segment reaches all readings."""
    ends, begins = [one.end for one in named], [one.begin for one in named]
    return (
        float("-inf") if not begins or low <= min(begins) + 1e-9 else low,
        float("inf") if not ends or high >= max(ends) - 1e-9 else high,
    )


def _smooth(story: Story) -> bool:
    """Whether a device read so often that its readings are alike, model or not."""
    often = max(len(track.t) for track in story.measured.tracks) > MOST_FITTED
    return often and story.speeds is not None and story.speeds.alike > ALIKE


def _thinned(measured: Measured, readings: int) -> Measured:
    k = -(-max(len(track.t) for track in measured.tracks) // readings)
    if k == 1:
        return measured
    a, b = (replace(one, t=one.t[::k], value=one.value[::k], lines=one.lines[::k])
            for one in measured.tracks)  # fmt: skip
    return replace(measured, tracks=(a, b))


def _chosen(rows: list[Compared], wanted: Wanted) -> Fit | None:
    effect = called_for(rows) if wanted.effect is None else wanted.effect
    return next((row.fit for row in rows if row.effect == effect), rows[0].fit)


def _white(made: Fit, story: Story) -> bool:
    """Whether the residuals are chance that lasts a few readings at most, or mere rounding."""
    reach = max(max(track.value) - min(track.value) for track in story.measured.tracks)
    rounded = made.noise < ROUNDING * reach
    return rounded or (neighbours(made) <= LASTING and not _smooth(story))


def _brake_right(made: Fit | None) -> bool:
    """Whether residuals beside a brake are chance. Noise that lasts looks like a brake that is not
    the track's own, which bends the velocities at the contact by more than such noise does; how
    much, the velocities of several brakes tell (sim.measured.events.sides)."""
    return made is None or made.asked.effect == "none" or neighbours(made) <= ALIKE


def _at_the_turn(made: Fit) -> bool:
    """Whether a cart that friction brakes is left without velocity by the bumper. A little more of
    it turns the cart round, at an instant that goes as a root: a descent comes to lie there, and no
    derivative tells an interval."""
    p = made.parameters
    if made.asked.effect not in RUBS or not p.approach > 0.0:
        return False
    middle, push = (p.v[0] + p.ratio * p.v[1]) / (1.0 + p.ratio), p.e * p.approach / (1.0 + p.ratio)
    after = middle - p.ratio * push, middle + push
    return min(map(abs, after)) < TURN * p.approach
