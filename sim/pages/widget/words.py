"""Sentences for readers: events, what is in the model. Its twin is `sim/web/src/words.js`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.widget.numbers import fixed, short, speed_unit

QUANTITIES = {
    "x": ("Position", "x", "m"),
    "v": ("Velocity", "v", "m/s"),
    "a": ("Acceleration", "a", "m/s²"),
    "F": ("Contact force", "F", "N"),
    "p": ("Momentum", "p", "kg m/s"),
    "energy": ("Kinetic energy", "E", "J"),
}
EFFECTS = {
    "friction": "friction",
    "incline": "a slope",
    "drag": "air resistance",
    "push": "pushes from outside",
    "spring": "springs between the carts",
    "magnets": "magnets",
    "release": "a release between the carts",
}
BOTH_FORCES = (
    "Each contact has one force in the program: it pushes both bodies, equally hard, "
    "away from each other. So the program assumes Newton’s third law; it cannot prove it."
)
HELD = "the track holds it"
NO_FORCE = "no contact force in this run"
IMPULSE_ONLY = "too large and too short to draw: see the impulses under “What happens”"
JUMP_ONLY = "where v jumps, the acceleration is too large and too short to draw"


def body(name: str) -> str:
    """A body as a sentence names it."""
    return {"left": "the left wall", "right": "the right wall"}.get(name, name)


def brief(name: str) -> str:
    """A body as a label names it."""
    return f"{name} wall" if name in ("left", "right") else name


def motion(velocity: float, decimals: int, scale: float) -> str:
    """A velocity in words: “0.20 m/s to the left”, “at rest”."""
    if abs(velocity) < 1e-9 * scale:
        return "at rest"
    way = "right" if velocity > 0 else "left"
    per, unit = speed_unit(scale)
    return f"{fixed(abs(velocity) / per, decimals)} {unit} to the {way}"


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
    pair = " and ".join(body(name) for name in names)
    pair = pair[:1].upper() + pair[1:]
    impulse = event.get("impulse") or 0.0
    after = ". ".join(
        f"{name}: {motion(event['after'][name] - camera, decimals['v'], scale)}"
        for name in carts
        if name in (event.get("after") or {})
    )
    after = f" {after}." if after else ""
    shown_impulse = f" Impulse on each: {short(impulse)} N s." if forces and impulse else ""
    if kind == "contact":
        if impulse and laws.get("-".join(names)) == "velcro":
            return f"{pair} hit and stay together.{shown_impulse}{after}"
        if impulse and _joined(event, scale):
            return f"{pair} hit and {_go_on(event, decimals, scale, camera)}.{shown_impulse}"
        if impulse:
            return f"{pair} hit each other and part at once.{shown_impulse}{after}"
        mover, other = (names[1], names[0]) if names[0] == "left" else (names[0], names[1])
        return f"{mover} reaches {body(other)}."
    if kind == "peak":
        if forces and event.get("force"):
            size = fixed(event["force"], decimals["F"])
            return f"{pair}: bumpers squeezed the most, {size} N on each."
        return f"{pair}: bumpers squeezed the most."
    if kind == "separate" and _joined(event, scale):
        who = " and ".join(body(name) for name in names)
        if len(carts) < len(names):
            return f"The push between {who} has ended; they stay together.{shown_impulse}{after}"
        together = _go_on(event, decimals, scale, camera)
        return f"The push between {who} has ended; they {together}.{shown_impulse}"
    if kind == "separate":
        return f"{pair} separate.{shown_impulse}{after}"
    if kind == "stick":
        return f"{pair} stay together.{after}"
    if kind == "stop":
        return f"{pair} stop: the track holds them." if names[1:] else f"{pair} stops: {HELD}."
    if kind == "start":
        return f"{pair} {'start' if names[1:] else 'starts'} to slide."
    if kind == "release":
        return f"The exploder between {pair} releases.{shown_impulse}{after}"
    return "End of the run." if kind == "end" else f"{kind}: {pair}."


def laws_of(contacts: Sequence[Mapping[str, Any]]) -> dict[str, str]:
    """The law of each pair, by its name such as A-B."""
    return {contact["pair"]: contact["law"] for contact in contacts}


def _joined(event: Mapping[str, Any], scale: float) -> bool:
    """Whether both bodies have one velocity after the event; a wall has none."""
    left, right = (
        0.0 if name in ("left", "right") else event["after"][name] for name in event["bodies"]
    )
    return bool(abs(left - right) < 1e-9 * scale)  # rounding, not motion


def _go_on(
    event: Mapping[str, Any], decimals: Mapping[str, int], scale: float, camera: float
) -> str:
    """How two bodies with one velocity move after the event."""
    cart = next(name for name in event["bodies"] if name not in ("left", "right"))
    seen = motion(event["after"][cart] - camera, decimals["v"], scale)
    return "stay together, at rest" if seen == "at rest" else f"go on together at {seen}"


def exit_sentence(name: str, side: str, velocity: float, decimals: int, scale: float) -> str:
    """What a reader sees when a cart leaves the picture."""
    per, unit = speed_unit(scale)
    speed = f"{fixed(abs(velocity) / per, decimals)}\u00a0{unit}"
    return f"{name} leaves the picture on the {side}, still {speed}."


def graph_note(quantity: str, events: Sequence[Mapping[str, Any]], curves: int) -> str:
    """What a graph with so many curves cannot show of a run, or why it is empty; else ""."""
    struck = any(event["kind"] == "contact" and event.get("impulse") for event in events)
    if struck and quantity in ("F", "a"):
        return IMPULSE_ONLY if quantity == "F" else JUMP_ONLY
    return NO_FORCE if quantity == "F" and not curves else ""


def model_sentences(header: Mapping[str, Any], *, told: bool) -> list[str]:
    """What is in this model. `told` False: before a prediction, nothing that tells of the run."""
    sentences = []
    if told:
        sentences += list(dict.fromkeys(_capital(phase["why"]) for phase in header["plan"]))
        if any(contact.get("stiffness") for contact in header["contacts"]):
            sentences.append(BOTH_FORCES)
    left_out = [EFFECTS.get(name, name) for name in header["notSimulated"]]
    if left_out:
        listed = ", ".join(left_out[:-1]) + (" and " if left_out[:-1] else "") + left_out[-1]
        sentences.append(f"Left out of this model: {listed}.")
    return sentences


def _capital(sentence: str) -> str:
    text = sentence[:1].upper() + sentence[1:]
    return text if text.endswith((".", "!", "?")) else f"{text}."
