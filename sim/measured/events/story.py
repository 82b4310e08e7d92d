"""All that is found out about one recording, in the order in which it is found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from sim.measured.events.by_hand import Given, with_contacts, with_segments
from sim.measured.events.contacts import Contact, chosen, contacts, where_near
from sim.measured.events.frames import Axis, Frames, frames_of, moved
from sim.measured.events.grid import grid_of
from sim.measured.events.in_step import StepMatch, in_step
from sim.measured.events.one_motion import check_two_motions
from sim.measured.events.outcome import Outcome, check_push, check_seen, outcome_of, perhaps_lost
from sim.measured.events.pushed_off import by_hands
from sim.measured.events.quantities import SCALES
from sim.measured.events.segments import segments
from sim.measured.events.sides import Speeds, sides_of, speeds_of
from sim.measured.events.stretch import Segment
from sim.measured.events.tails import with_tail
from sim.measured.events.together import Together, seen_by_one, together
from sim.measured.events.wild import Aside
from sim.measured.refusal import FitError
from sim.measured.tracks import Measured
from sim.scene.said import said


@dataclass(frozen=True, slots=True, kw_only=True)
class Hints:
    """What a reader says: which contact, which axes. `distance`: m, of the marks at the touch."""

    at: float | None = None  # s
    flips: tuple[str, ...] = ()
    zeros: Mapping[str, float] = field(default_factory=dict)
    distance: float | None = None
    together: bool = False  # the carts stayed together, whatever a sensor that lost one tells
    segments: tuple[Given, ...] = ()


@dataclass(frozen=True, slots=True)
class Story:
    """As far as it goes; `refused` says why it does not go on. `measured` is on the common axis."""

    measured: Measured
    contacts: tuple[Contact, ...] = ()
    contact: Contact | None = None
    segments: tuple[Segment, ...] = ()
    frames: Frames | None = None
    speeds: Speeds | None = None
    step: StepMatch | None = None
    outcome: Outcome | None = None
    together: Together | None = None  # where the velocities alone tell a stick
    lost: int | None = None  # the cart of which a reader says that the other tells its velocity
    refused: FitError | None = None
    aside: tuple[Aside, ...] = ()


def story_of(measured: Measured, hints: Hints = Hints()) -> Story:
    """Everything about two carts; never raises FitError."""
    story = Story(measured)
    try:
        grid = grid_of(measured.tracks)
        every = contacts(grid)
        hands = by_hands(grid, every)
        found = [one for one in every if one not in hands]
        found = found if measured.own or hands else where_near(grid, found)
        found = with_contacts(grid, found, hints.segments)
        contact = chosen(found, _at(hints))
        named = segments(grid, found)
        if contact is not None and not hints.segments:
            longer = with_tail(contact, named)
            found = [longer if one == contact else one for one in found]
            named, contact = segments(grid, found) if longer != contact else named, longer
        named = with_segments(grid, named, hints.segments, found)
        story = replace(story, contacts=tuple(found), contact=contact, segments=tuple(named))
        if contact is None:
            raise _no_contact(by_hands=bool(hands))
        step = in_step(grid, contact.begin, contact.end)
        story = replace(story, step=step)
        sides = sides_of(measured.tracks, contact, named)
        if not measured.own and not hints.flips:
            check_two_motions(measured)
        raw = speeds_of(sides)
        frames = frames_of(measured, raw, hints.flips, hints.zeros, hints.distance)
        plain = frames.axes == (Axis(1, 0.0), Axis(1, 0.0))
        axis = measured if plain else moved(measured, frames)
        sides = sides if plain else sides_of(axis.tracks, contact, named)
        speeds = raw if plain else speeds_of(sides)
        two = measured.own or frames.joined
        lost = perhaps_lost(speeds) if two and hints.together else None
        speeds = speeds if lost is None else seen_by_one(speeds, lost)
        story = replace(story, frames=frames, speeds=speeds, measured=axis, lost=lost)
        check_push(speeds, step, contact, _frame(measured), measured.names, lost)
        outcome, beside = outcome_of(speeds), None
        if hints.together and outcome != "stick":
            raise FitError(
                said("you say that the carts stayed together, but both are seen to part"),
                said("leave that out"),
                "parted",
            )
        if two and outcome == "bounce":
            check_seen(speeds, measured.names)
        if outcome == "stick" and lost is None:
            scale = SCALES * max(map(abs, speeds.v[2:])) if two else 0.0
            beside = together(sides, scale)
            if beside and not two and beside.opens(speeds.approach):
                outcome = "bounce"
        return replace(story, outcome=outcome, together=beside)
    except FitError as error:
        return replace(story, refused=error)


def _no_contact(*, by_hands: bool) -> FitError:
    if by_hands:
        return FitError(
            said(
                "both carts set out from rest, each away from its sensor: they are pushed towards "
                "each other, by hands, and the readings end before they meet"
            ),
            said("let the recording go on until the carts have met and parted"),
            "no-contact",
        )
    return FitError(
        said(
            "no contact is found: at no time do the readings show that both carts change their "
            "velocity together"
        ),
        said(
            "choose the seconds around one contact in which nobody holds a cart; after a weak "
            "push, push harder or take finer readings"
        ),
        "no-contact",
    )


def _at(hints: Hints) -> float | None:
    """s. Which contact: the one that was asked for, or set by hand."""
    by_hand = [0.5 * (one.begin + one.end) for one in hints.segments if one.kind == "contact"]
    return hints.at if hints.at is not None or not by_hand else by_hand[-1]


def _frame(measured: Measured) -> float:
    """s. From one reading to the next, of the slower sensor."""
    steps = []
    for track in measured.tracks:
        gaps = sorted(b - a for a, b in zip(track.t[:-1], track.t[1:], strict=True))
        steps.append(gaps[len(gaps) // 2])
    return max(steps)
