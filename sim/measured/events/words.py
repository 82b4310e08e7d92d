"""What happened, in sentences."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.measured.events.momentum import Momentum
from sim.measured.events.rungs import Rung
from sim.measured.events.sides import Speeds
from sim.measured.events.story import Story
from sim.measured.words import places_for, with_half
from sim.scene.notation import number

OUTCOMES = {
    "bounce": "The carts bounce: they come together, push each other and part.",
    "stick": "The carts stick: after the contact they move on together. There is no bounciness.",
    "explosion": "An explosion: the carts were together and push each other apart. There is no "
    "bounciness.",
}
PARTED_PERHAPS = (
    "The carts come together and push each other. Whether they part again or stay together, these "
    "readings do not tell."
)
STUCK_PERHAPS = (
    "After the contact the carts move on together, as far as these readings show: bounciness e is "
    "below "
)
STEPS = {"nothing": "nothing that brakes", "friction": "friction", "tilt": "a tilt", "drag": "drag",
         "both": "friction and a tilt"}  # fmt: skip


def of_story(story: Story, names: tuple[str, str]) -> list[str]:
    """Outcome, axes, other contacts, what brakes."""
    said = [OUTCOMES[story.outcome]] if story.outcome else []
    if story.outcome == "stick" and story.together and story.speeds:
        limit = story.together.below(story.speeds.approach)
        said = [STUCK_PERHAPS + number(limit, 2) + "."] if limit else said
    if story.lost is not None:
        said.append(
            f"The velocity of {names[story.lost]} after the contact is that of "
            f"{names[1 - story.lost]}: you say that they stayed together. So these readings do not "
            "test that."
        )
    said += story.frames.said if story.frames else ()
    others = [one for one in story.contacts if one != story.contact]
    if others and story.contact:
        listed = ", ".join(f"{one.middle:.2f} s" for one in others)
        said.append(
            f"The contact at {story.contact.middle:.2f} s is taken; both carts also change their "
            f"velocity at {listed}. To take another, use only the readings around it."
        )
    return said


def as_sure(said: Sequence[str], known: Sequence[Mapping[str, Any]]) -> list[str]:
    """The sentences, without that the carts part where e, of the rows that are told, may be 0."""
    perhaps = any(one["key"] == "e" and one["low"] <= 0.0 for one in known)
    return [PARTED_PERHAPS if perhaps and one == OUTCOMES["bounce"] else one for one in said]


def of_taken(speeds: Speeds) -> str:
    """What the velocities count: the model's own effect is chosen by whoever fits it."""
    return (
        f"Velocities just before and after the contact are told with {STEPS[speeds.step]}; what "
        "the model itself counts is what you choose for it."
    )


BRAKES = {"friction": "Friction", "tilt": "A tilt", "drag": "Drag"}


def of_scatter(speeds: Speeds) -> str:
    """The line of the ladder: what readings cannot show."""
    scatter = _millimetres(speeds.scatter)
    return f"These readings scatter by {scatter}: what changes less, they cannot show."


def of_rung(rung: Rung) -> str:
    """What an effect changes beside the contact, and whether the readings show it."""
    begin = (
        f"{BRAKES[rung.step]} changes where the carts are beside the contact by "
        f"{_millimetres(rung.changes)}"
    )
    if rung.verdict == "not-shown":
        return f"{begin}: your readings cannot show it."
    errors = f"by {_millimetres(rung.missed)} with it and {_millimetres(rung.without)} without"
    if rung.verdict == "shown":
        return f"{begin}: your readings show it. They are missed {errors}."
    return f"{begin}: your readings do not bear it out. They are missed {errors}."


def _millimetres(metres: float) -> str:
    return f"{number(1e3 * metres, 2)} mm"


def of_momentum(found: Momentum) -> str:
    """Before, after, and whether they agree."""
    sides = (
        f"Momentum before: {with_half(found.before, found.before_half, 'kg m/s')}, after: "
        f"{with_half(found.after, found.after_half, 'kg m/s')}. "
    )
    places = places_for(found.change_half + found.friction)
    limit = number(found.change_half + found.friction, places)
    change = f"the change of {number(found.change, places)} kg m/s is"
    if found.agree:
        return (
            f"{sides}They agree: {change} within {limit} kg m/s, which counts the "
            "velocities' uncertainty and what friction may take while the carts touch."
        )
    return (
        f"{sides}They do not agree: {change} more than {limit} kg m/s, the velocities' "
        "uncertainty and what friction may take while the carts touch. Something else pushed, or a "
        "mass or a scale is wrong."
    )
