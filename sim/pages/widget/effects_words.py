"""What acts in a scene, in words. Twin: `sim/web/src/effects-words.js`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sim.pages.widget.effects_forces import agent, linked_pairs
from sim.pages.widget.numbers import short
from sim.pages.widget.words import EFFECTS

LEFT_OUT = EFFECTS | {"release": "exploders"}


def acting_sentences(header: Mapping[str, Any], *, numbers: bool) -> str:
    """In and out of the model, for below the picture. `numbers` False: they would tell a force."""
    if not header["effects"]:
        return ""
    acting = [_phrase(effect, header, numbers) for effect in header["effects"] if effect["active"]]
    inside = "; ".join(acting) if acting else "nothing but the contacts between the carts"
    left_out = [LEFT_OUT.get(name, name) for name in header["notSimulated"]]
    outside = f" Left out: {', '.join(left_out)}." if left_out else ""
    return f"In this model: {inside}.{outside}"


def _phrase(effect: Mapping[str, Any], header: Mapping[str, Any], numbers: bool) -> str:
    kind, n = effect["kind"], effect["numbers"]
    names = effect["between"] or effect["carts"]
    everyone = len(effect["carts"]) == len(header["bodies"])
    on = "" if everyone else f" on {listed(effect['carts'])}"
    both = listed([_body(name) for name in names])

    def told(text: str) -> str:
        return f", {text}" if numbers else ""

    if kind == "friction":
        static = n.get("static", n["coefficient"])
        rest = f" (at rest up to {short(static)})" if static > n["coefficient"] else ""
        return f"friction{on} by the track" + told(f"μ = {short(n['coefficient'])}{rest}")
    if kind == "incline":
        return f"a slope{on}, {slope_text(n['angle'])}"
    if kind == "drag":
        parts = [
            f"{short(n[key])} N per {unit}"
            for key, unit in (("linear", "m/s"), ("quadratic", "(m/s)²"))
            if n.get(key)
        ]
        return f"drag{on} by the air" + told(" and ".join(parts) or "0 N")
    if kind == "push":
        when = push_times(effect)
        return f"a push on {names[0]} by {agent(effect)}" + told(push_text(n["force"])) + when
    if kind == "spring":
        damped = ", damped" if n.get("damping") else ""
        stiff = f"{short(n['stiffness'])} N/m, natural length {short(n['length'])} m"
        return f"a spring between {both}{damped}" + told(stiff)
    if kind == "magnets":
        return f"magnets on {both}, like poles facing"
    energy = told(f"{short(n['energy'])} J")
    return f"an exploder between {both}{energy}, at {short(n.get('at', 0.0))} s"


def force_name(header: Mapping[str, Any]) -> str:
    """What the graph of F shows: springs and magnets act without contact."""
    return "force between them" if linked_pairs(header) else "contact force"


def push_text(force: float) -> str:
    """A push with its direction: “2 N to the right”."""
    return f"{short(abs(force))} N to the {'right' if force >= 0 else 'left'}"


def push_times(effect: Mapping[str, Any]) -> str:
    """When a push lasts: “, from 1 s to 1.5 s”; nothing where it always does."""
    begin, end = effect["numbers"].get("from", 0.0), effect["numbers"].get("until")
    start = f", from {short(begin)} s" if begin or end is not None else ""
    return start + (f" to {short(end)} s" if end is not None else "")


def slope_text(angle: float) -> str:
    """The tilt of the track: “2° down to the right”; angle in rad."""
    size = short(abs(math.degrees(angle)))
    if size == "0":
        return "0°: the track is level"
    return f"{size}° down to the {'right' if angle > 0 else 'left'}"


def push_marks(header: Mapping[str, Any], *, forces: bool) -> list[tuple[float, str]]:
    """When pushes begin and end, with what to say; these are no events of the run itself."""
    marks = []
    for effect in header["effects"]:
        if effect["kind"] != "push" or not effect["active"]:
            continue
        name, by, n = effect["carts"][0], agent(effect), effect["numbers"]
        size = f": {push_text(n['force'])}" if forces else ""
        begin, end = n.get("from", 0.0), n.get("until")
        if begin <= header["until"]:
            marks.append((float(begin), f"The push on {name} by {by} begins{size}."))
        if end is not None and begin < end <= header["until"]:
            marks.append((float(end), f"The push on {name} by {by} ends."))
    return marks


def listed(names: list[str]) -> str:
    """“A”, “A and B”, “A, B and C”."""
    return " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else names[0]


def _body(name: str) -> str:
    return {"left": "the left wall", "right": "the right wall"}.get(name, name)
