"""What acts in a scene, in words. Twin: `sim/web/src/effects-words.js`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sim.pages.language import mark, tr
from sim.pages.widget.effects_forces import agent, linked_pairs
from sim.pages.widget.numbers import short
from sim.pages.widget.words import EFFECTS, body, listed

LEFT_OUT = EFFECTS | {"release": mark("exploders")}


def acting_sentences(header: Mapping[str, Any], *, numbers: bool) -> str:
    """In and out of the model, for below the picture. `numbers` False: they would tell a force."""
    if not header["effects"]:
        return ""
    acting = [_phrase(effect, header, numbers) for effect in header["effects"] if effect["active"]]
    inside = "; ".join(acting) if acting else tr("nothing but the contacts between the carts")
    left_out = ", ".join(tr(LEFT_OUT.get(name, name)) for name in header["notSimulated"])
    model = tr("In this model: {effects}.", effects=inside)
    return f"{model} {tr('Left out: {effects}.', effects=left_out)}" if left_out else model


def _phrase(effect: Mapping[str, Any], header: Mapping[str, Any], numbers: bool) -> str:
    kind, n = effect["kind"], effect["numbers"]
    names = effect["between"] or effect["carts"]
    everyone = len(effect["carts"]) == len(header["bodies"])
    on = listed(effect["carts"])
    both = listed([body(name) for name in names])

    def told(*parts: str) -> str:
        return ", ".join(filter(None, parts))

    def seen(text: str) -> str:
        return text if numbers else ""

    if kind == "friction":
        static = n.get("static", n["coefficient"])
        size = f"μ = {short(n['coefficient'])}"
        if static > n["coefficient"]:
            size += " " + tr("(at rest up to {coefficient})", coefficient=short(static))
        if everyone:
            return told(tr("friction by the track"), seen(size))
        return told(tr("friction on {carts} by the track", carts=on), seen(size))
    if kind == "incline":
        slope = slope_text(n["angle"])
        if everyone:
            return told(tr("a slope"), slope)
        return told(tr("a slope on {carts}", carts=on), slope)
    if kind == "drag":
        parts = [
            tr("{size} N per {unit}", size=short(n[key]), unit=unit)
            for key, unit in (("linear", "m/s"), ("quadratic", "(m/s)²"))
            if n.get(key)
        ]
        drag = tr("drag by the air") if everyone else tr("drag on {carts} by the air", carts=on)
        return told(drag, seen(listed(parts) or "0 N"))
    if kind == "push":
        return told(
            tr("a push on {cart} by {agent}", cart=names[0], agent=agent(effect)),
            seen(push_text(n["force"])),
            push_times(effect),
        )
    if kind == "spring":
        length = tr("natural length {length} m", length=short(n["length"]))
        return told(
            tr("a spring between {bodies}", bodies=both),
            tr("damped") if n.get("damping") else "",
            seen(f"{short(n['stiffness'])} N/m, {length}"),
        )
    if kind == "magnets":
        return tr("magnets on {bodies}, like poles facing", bodies=both)
    return told(
        tr("an exploder between {bodies}", bodies=both),
        seen(f"{short(n['energy'])} J"),
        tr("at {time} s", time=short(n.get("at", 0.0))),
    )


def size_name(header: Mapping[str, Any]) -> str:
    """What the graph of F shows: springs and magnets act without contact."""
    if linked_pairs(header):
        return tr("Size of the force between them")
    return tr("Size of the contact force")


def push_text(force: float) -> str:
    """A push with its direction: “2 N to the right”."""
    size = short(abs(force))
    if force >= 0:
        return tr("{size} N to the right", size=size)
    return tr("{size} N to the left", size=size)


def push_times(effect: Mapping[str, Any]) -> str:
    """When a push lasts: “from 1 s to 1.5 s”; nothing where it always does."""
    begin, end = effect["numbers"].get("from", 0.0), effect["numbers"].get("until")
    if end is not None:
        return tr("from {from} s to {until} s", **{"from": short(begin), "until": short(end)})
    return tr("from {from} s", **{"from": short(begin)}) if begin else ""


def slope_text(angle: float) -> str:
    """The tilt of the track: “2° down to the right”; angle in rad."""
    size = short(abs(math.degrees(angle)))
    if size == "0":
        return tr("0°: the track is level")
    if angle > 0:
        return tr("{angle}° down to the right", angle=size)
    return tr("{angle}° down to the left", angle=size)


def push_marks(header: Mapping[str, Any], *, forces: bool) -> list[tuple[float, str]]:
    """When pushes begin and end, with what to say; these are no events of the run itself."""
    marks = []
    for effect in header["effects"]:
        if effect["kind"] != "push" or not effect["active"]:
            continue
        who, n = {"cart": effect["carts"][0], "agent": agent(effect)}, effect["numbers"]
        begin, end = n.get("from", 0.0), n.get("until")
        if begin <= header["until"]:
            begins = tr("The push on {cart} by {agent} begins.", **who)
            if forces:
                size = push_text(n["force"])
                begins = tr("The push on {cart} by {agent} begins: {force}.", **who, force=size)
            marks.append((float(begin), begins))
        if end is not None and begin < end <= header["until"]:
            marks.append((float(end), tr("The push on {cart} by {agent} ends.", **who)))
    return marks
