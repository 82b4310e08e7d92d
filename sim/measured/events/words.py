"""What happened, in sentences."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.measured.events.momentum import Momentum
from sim.measured.events.rungs import Rung
from sim.measured.events.sides import Speeds
from sim.measured.events.story import Story
from sim.measured.words.fit import places_for, with_half
from sim.scene.notation import number
from sim.scene.said import Said, commas, joined, said

OUTCOMES = {
    "bounce": said("The carts bounce: they come together, push each other and part."),
    "stick": said(
        "The carts stick: after the contact they move on together. There is no bounciness."
    ),
    "explosion": said(
        "An explosion: the carts were together and push each other apart. There is no bounciness."
    ),
}
PARTED_PERHAPS = said(
    "The carts come together and push each other. Whether they part again or stay together, these "
    "readings do not tell."
)
STEPS = {
    "nothing": said("nothing that brakes"),
    "friction": said("friction"),
    "tilt": said("a tilt"),
    "drag": said("drag"),
    "both": said("friction and a tilt"),
}


def of_story(story: Story, names: tuple[str, str]) -> list[str]:
    """Outcome, axes, other contacts, what brakes."""
    found: list[str] = [OUTCOMES[story.outcome]] if story.outcome else []
    if story.outcome == "stick" and story.together and story.speeds:
        limit = story.together.below(story.speeds.approach)
        found = [_stuck(limit)] if limit else found
    if story.lost is not None:
        found.append(
            said(
                "The velocity of {lost} after the contact is that of {other}: you say that they "
                "stayed together. So these readings do not test that.",
                lost=names[story.lost],
                other=names[1 - story.lost],
            )
        )
    found += story.frames.sentences if story.frames else ()
    others = [one for one in story.contacts if one != story.contact]
    if others and story.contact:
        found.append(
            said(
                "The contact at {taken} s is taken; both carts also change their velocity at "
                "{others}. To take another, use only the readings around it.",
                taken=f"{story.contact.middle:.2f}",
                others=commas([f"{one.middle:.2f} s" for one in others]),
            )
        )
    return found


def _stuck(limit: float) -> Said:
    return said(
        "After the contact the carts move on together, as far as these readings show: bounciness e "
        "is below {limit}.",
        limit=number(limit, 2),
    )


def as_sure(sentences: Sequence[str], known: Sequence[Mapping[str, Any]]) -> list[str]:
    """The sentences, without that the carts part where e, of the rows that are told, may be 0."""
    perhaps = any(one["key"] == "e" and one["low"] <= 0.0 for one in known)
    return [PARTED_PERHAPS if perhaps and one == OUTCOMES["bounce"] else one for one in sentences]


def of_taken(speeds: Speeds) -> str:
    """What the velocities count: the model's own effect is chosen by whoever fits it."""
    return said(
        "Velocities just before and after the contact are told with {brake}; what the model itself "
        "counts is what you choose for it.",
        brake=STEPS[speeds.step],
    )


def of_scatter(speeds: Speeds) -> str:
    """The line of the ladder: what readings cannot show."""
    return said(
        "These readings scatter by {scatter}: what changes less, they cannot show.",
        scatter=_millimetres(speeds.scatter),
    )


def of_rung(rung: Rung) -> str:
    """What an effect changes beside the contact, and whether the readings show it."""
    change = _change(rung.step, _millimetres(rung.changes))
    if rung.verdict == "not-shown":
        return said("{change}: your readings cannot show it.", change=change)
    beside, without = _millimetres(rung.missed), _millimetres(rung.without)
    missed = said(
        "They are missed by {beside} with it and {without} without.", beside=beside, without=without
    )
    if rung.verdict == "shown":
        return joined(said("{change}: your readings show it.", change=change), missed)
    return joined(said("{change}: your readings do not bear it out.", change=change), missed)


def _change(step: str, size: str) -> Said:
    if step == "friction":
        return said("Friction changes where the carts are beside the contact by {size}", size=size)
    if step == "tilt":
        return said("A tilt changes where the carts are beside the contact by {size}", size=size)
    return said("Drag changes where the carts are beside the contact by {size}", size=size)


def _millimetres(metres: float) -> str:
    return f"{number(1e3 * metres, 2)} mm"


def of_momentum(found: Momentum) -> str:
    """Before, after, and whether they agree."""
    sides = said(
        "Momentum before: {before}, after: {after}.",
        before=with_half(found.before, found.before_half, "kg m/s"),
        after=with_half(found.after, found.after_half, "kg m/s"),
    )
    most = found.change_half + found.friction
    places = places_for(most)
    change, limit = f"{number(found.change, places)} kg m/s", f"{number(most, places)} kg m/s"
    if found.agree:
        verdict = said(
            "They agree: the change of {change} is within {limit}, which counts the velocities' "
            "uncertainty and what friction may take while the carts touch.",
            change=change,
            limit=limit,
        )
    else:
        verdict = said(
            "They do not agree: the change of {change} is more than {limit}, the velocities' "
            "uncertainty and what friction may take while the carts touch. Something else pushed, "
            "or a mass or a scale is wrong.",
            change=change,
            limit=limit,
        )
    return joined(sides, verdict)
