"""Sentences for readers: events, what is in the model. Its twin is `sim/web/src/words.js`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.language import heard, mark, tr
from sim.pages.widget.numbers import fixed, short, speed_unit

QUANTITIES = {
    "x": (mark("Position"), "x", "m"),
    "v": (mark("Velocity"), "v", "m/s"),
    "a": (mark("Acceleration"), "a", "m/s²"),
    "F": (mark("Contact force"), "F", "N"),
    "p": (mark("Momentum"), "p", "kg m/s"),
    "energy": (mark("Kinetic energy"), "E", "J"),
}
EFFECTS = {
    "friction": mark("friction"),
    "incline": mark("a slope"),
    "drag": mark("air resistance"),
    "push": mark("pushes from outside"),
    "spring": mark("springs between the carts"),
    "magnets": mark("magnets"),
    "release": mark("a release between the carts"),
}
BOTH_FORCES = mark(
    "Each contact has one force in the program: it pushes both bodies, equally hard, "
    "away from each other. So the program assumes Newton’s third law; it cannot prove it."
)
NO_FORCE = mark("no contact force in this run")
IMPULSE_ONLY = mark("too large and too short to draw: see the impulses under “What happens”")
JUMP_ONLY = mark("where v jumps, the acceleration is too large and too short to draw")


def body(name: str) -> str:
    """A body as a sentence names it."""
    return {"left": tr("the left wall"), "right": tr("the right wall")}.get(name, name)


def brief(name: str) -> str:
    """A body as a label names it."""
    return {"left": tr("left wall"), "right": tr("right wall")}.get(name, name)


def force_on(on: str, by: str) -> str:
    """A force with both bodies, as a sentence names them."""
    return tr("force on {on} by {by}", on=on, by=by)


def listed(names: Sequence[str]) -> str:
    """“A”, “A and B”, “A, B and C”."""
    if len(names) < 2:
        return "".join(names)
    return tr("{first} and {last}", first=", ".join(names[:-1]), last=names[-1])


def motion(velocity: float, decimals: int, scale: float) -> str:
    """A velocity in words: “0.20 m/s to the left”, “at rest”."""
    if _is_rest(velocity, scale):
        return tr("at rest")
    per, unit = speed_unit(scale)
    speed = f"{fixed(abs(velocity) / per, decimals)}\u00a0{unit}"
    if velocity > 0:
        return tr("{speed} to the right", speed=speed)
    return tr("{speed} to the left", speed=speed)


def _is_rest(velocity: float, scale: float) -> bool:
    return abs(velocity) < 1e-9 * scale


def event_sentence(
    event: Mapping[str, Any],
    *,
    decimals: Mapping[str, int],
    scale: float,
    camera: float,
    forces: bool,
    laws: Mapping[str, str],
) -> str:
    """What happens at an event. Speeds are as the camera sees them; `scale` in m/s.

    `laws`: the law of each pair, by its name such as A-B.
    """
    names = list(event["bodies"])
    kind = event["kind"]
    carts = [name for name in names if name not in ("left", "right")]
    both = listed([body(name) for name in names])
    pair = both[:1].upper() + both[1:]
    impulse = event.get("impulse") or 0.0
    after = ". ".join(
        f"{name}: {motion(event['after'][name] - camera, decimals['v'], scale)}"
        for name in carts
        if name in (event.get("after") or {})
    )
    after = f"{after}." if after else ""
    size = f"{short(impulse)}\u00a0N\u00a0s"
    shown = tr("Impulse on each: {size}.", size=size) if forces and impulse else ""
    if kind == "contact":
        if impulse and laws.get("-".join(names)) == "velcro":
            return _told(tr("{pair} hit and stay together.", pair=pair), shown, after)
        if impulse and _joined(event, scale):
            return _told(_hit_and_go_on(event, pair, decimals, scale, camera), shown)
        if impulse:
            return _told(tr("{pair} hit each other and part at once.", pair=pair), shown, after)
        mover, other = (names[1], names[0]) if names[0] == "left" else (names[0], names[1])
        return tr("{mover} reaches {other}.", mover=mover, other=body(other))
    if kind == "peak":
        if forces and event.get("force"):
            force = f"{fixed(event['force'], decimals['F'])}\u00a0N"
            return tr("{pair}: bumpers squeezed the most, {force} on each.", pair=pair, force=force)
        return tr("{pair}: bumpers squeezed the most.", pair=pair)
    if kind == "separate" and _joined(event, scale):
        if len(carts) < len(names):
            ended = tr("The push between {pair} has ended; they stay together.", pair=both)
            return _told(ended, shown, after)
        return _told(_push_ended(event, both, decimals, scale, camera), shown)
    if kind == "separate":
        return _told(tr("{pair} separate.", pair=pair), shown, after)
    if kind == "stick":
        return _told(tr("{pair} stay together.", pair=pair), after)
    if kind == "stop":
        if names[1:]:
            return tr("{pair} stop: the track holds them.", pair=pair)
        return tr("{cart} stops: the track holds it.", cart=pair)
    if kind == "start":
        if names[1:]:
            return tr("{pair} start to slide.", pair=pair)
        return tr("{cart} starts to slide.", cart=pair)
    if kind == "release":
        return _told(tr("The exploder between {pair} releases.", pair=pair), shown, after)
    return tr("End of the run.") if kind == "end" else f"{kind}: {pair}."


def _told(*sentences: str) -> str:
    return " ".join(filter(None, sentences))


def laws_of(contacts: Sequence[Mapping[str, Any]]) -> dict[str, str]:
    """The law of each pair, by its name such as A-B."""
    return {contact["pair"]: contact["law"] for contact in contacts}


def _joined(event: Mapping[str, Any], scale: float) -> bool:
    """Whether both bodies have one velocity after the event; a wall has none."""
    left, right = (
        0.0 if name in ("left", "right") else event["after"][name] for name in event["bodies"]
    )
    return _is_rest(left - right, scale)  # rounding, not motion


def _together(
    event: Mapping[str, Any], decimals: Mapping[str, int], scale: float, camera: float
) -> str | None:
    """The one velocity that two bodies have after the event; None: they are at rest."""
    cart = next(name for name in event["bodies"] if name not in ("left", "right"))
    seen = event["after"][cart] - camera
    return None if _is_rest(seen, scale) else motion(seen, decimals["v"], scale)


def _hit_and_go_on(
    event: Mapping[str, Any], pair: str, decimals: Mapping[str, int], scale: float, camera: float
) -> str:
    how = _together(event, decimals, scale, camera)
    if how is None:
        return tr("{pair} hit and stay together, at rest.", pair=pair)
    return tr("{pair} hit and go on together at {velocity}.", pair=pair, velocity=how)


def _push_ended(
    event: Mapping[str, Any], pair: str, decimals: Mapping[str, int], scale: float, camera: float
) -> str:
    how = _together(event, decimals, scale, camera)
    if how is None:
        return tr("The push between {pair} has ended; they stay together, at rest.", pair=pair)
    return tr(
        "The push between {pair} has ended; they go on together at {velocity}.",
        pair=pair,
        velocity=how,
    )


def exit_sentence(name: str, side: str, velocity: float, decimals: int, scale: float) -> str:
    """What a reader sees when a cart leaves the picture."""
    per, unit = speed_unit(scale)
    speed = f"{fixed(abs(velocity) / per, decimals)}\u00a0{unit}"
    if side == "right":
        return tr("{name} leaves the picture on the right, still {speed}.", name=name, speed=speed)
    return tr("{name} leaves the picture on the left, still {speed}.", name=name, speed=speed)


def graph_note(quantity: str, events: Sequence[Mapping[str, Any]], curves: int) -> str:
    """What a graph with so many curves cannot show of a run, or why it is empty; else ""."""
    struck = any(event["kind"] == "contact" and event.get("impulse") for event in events)
    if struck and quantity in ("F", "a"):
        return tr(IMPULSE_ONLY if quantity == "F" else JUMP_ONLY)
    return tr(NO_FORCE) if quantity == "F" and not curves else ""


def model_sentences(header: Mapping[str, Any], *, told: bool) -> list[str]:
    """What is in this model. `told` False: before a prediction, nothing that tells of the run."""
    sentences = []
    if told:
        sentences += list(
            dict.fromkeys(_capital(heard_why(phase["why"])) for phase in header["plan"])
        )
        if any(contact.get("stiffness") for contact in header["contacts"]):
            sentences.append(tr(BOTH_FORCES))
    left_out = [tr(EFFECTS.get(name, name)) for name in header["notSimulated"]]
    if left_out:
        sentences.append(tr("Left out of this model: {effects}.", effects=listed(left_out)))
    return sentences


def heard_why(why: str) -> str:
    """Why a phase is solved as it is: clauses between semicolons."""
    return "; ".join(map(heard, why.split("; ")))


def _capital(sentence: str) -> str:
    text = sentence[:1].upper() + sentence[1:]
    return text if text.endswith((".", "!", "?")) else f"{text}."
