"""A scene as a program in plain Python, for readers who want to see all of a model, and change it.

It steps (semi-implicit Euler, dt a hundredth of the shortest quarter swing), so it is nearly right
where the run is exact, and it holds only what its scene calls for: each effect and each kind of
contact is a piece of text that is left out where nothing needs it.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Mapping
from typing import Any

from sim.bridge import model_pieces as piece
from sim.bridge.protocol import plain_of
from sim.dynamics.laws.lookup import finite_law
from sim.scene import Scene, read_scene

PARTS = 100
"""Steps in a quarter swing: the end of a contact is then met within a hundredth of it."""

FEWEST, MOST_STEPS = 20_000, 2_000_000
"""Steps of a whole run: fine enough to print, and no longer than some seconds."""

STEPPED = ("bumper", "paper", "push-only", "push-only-uncorrected", "hertz")


def model_text(scene: Scene) -> str:
    """The program. It prints where the carts are, twenty times, and how fast they end."""
    kinds = {effect.kind for effect in scene.effects}
    laws = {contact.law for contact in scene.contacts if contact is not None}
    joins = "velcro" in laws or "release" in kinds
    kicked = joins or "instant" in laws
    text = piece.HEAD.format(
        title=" ".join((scene.title or "Carts").split()),
        names=[cart.name for cart in scene.carts],
        mass=[cart.mass for cart in scene.carts],
        x=[cart.position for cart in scene.carts],
        v=[cart.velocity for cart in scene.carts],
        half=[cart.length / 2 for cart in scene.carts],
        end=scene.track.length,
        until=scene.until,
        dt=_step(scene),
        contacts="".join(f"    {row},\n" for row in _contacts(scene)),
    )
    text += "".join(f"{name} = {rows!r}  # {says}\n" for name, rows, says in _effects(scene))
    text += piece.PLACES
    if kicked:
        text += piece.KICK
    if kicked or "friction" in kinds:
        text += piece.GROUPS if joins else piece.ALONE
    text += piece.STEP
    text += piece.CONTACT_FORCES if laws & set(STEPPED) else ""
    text += "".join(force for kind, force in piece.FORCES.items() if kind in kinds)
    text += piece.FRICTION if "friction" in kinds else piece.MOVE if joins else piece.MOVE_ALONE
    text += piece.IMPACTS if laws & {"instant", "velcro"} else ""
    text += piece.RELEASE if "release" in kinds else ""
    return text + piece.RUN


def model_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """The program of the values that the page shows; raises `SceneError`."""
    plain = plain_of(request)
    return {"text": model_text(read_scene(plain))}, array("d")


def _contacts(scene: Scene) -> list[tuple[int | None, int | None, str, float, float, float]]:
    """Left, right, law, k, e and damping c of every pair that may touch. None is a wall."""
    n = len(scene.carts)
    found: list[tuple[int | None, int | None, str, float, float, float]] = []
    for k, contact in enumerate(scene.contacts):
        if contact is None:
            continue
        left, right = (k - 1 if k else None), (k if k < n else None)
        law = finite_law(contact)
        damper = getattr(law, "damper", None)
        c = damper(_reduced(scene, k)) if damper and contact.law != "bumper" else 0.0
        e = 0.0 if contact.restitution is None else contact.restitution
        found.append((left, right, contact.law, contact.stiffness or 0.0, e, c))
    return found


def _effects(scene: Scene) -> list[tuple[str, list[tuple[object, ...]], str]]:
    """The lists that the pieces of the effects read."""
    number = {cart.name: i for i, cart in enumerate(scene.carts)}
    g = scene.gravity
    angle = [0.0] * len(scene.carts)
    rows: dict[str, list[tuple[object, ...]]] = {}
    for effect in scene.effects:
        n = effect.numbers
        on = [number[name] for name in effect.carts]
        pair = tuple(number.get(name) for name in effect.between or ())
        if effect.kind == "incline":
            for i in on:
                angle[i] += n["angle"]
            rows.setdefault("slopes", []).extend((i, g * math.sin(n["angle"])) for i in on)
        elif effect.kind == "drag":
            both = (n.get("linear", 0.0), n.get("quadratic", 0.0))
            rows.setdefault("drags", []).extend((i, *both) for i in on)
        elif effect.kind == "push":
            times = (n.get("from", 0.0), n.get("until", scene.until))
            rows.setdefault("pushes", []).append((on[0], n["force"], *times))
        elif effect.kind == "spring":
            three = (n["stiffness"], n["length"], n.get("damping", 0.0))
            rows.setdefault("springs", []).append((*pair, *three))
        elif effect.kind == "magnets":
            rows.setdefault("magnets", []).append((*pair, n["strength"], n.get("power", 3.0)))
        elif effect.kind == "release":
            rows.setdefault("releases", []).append((n.get("at", 0.0), *pair, n["energy"]))
    for effect in scene.effects:
        if effect.kind == "friction":
            n, low = effect.numbers, effect.numbers["coefficient"]
            for i in (number[name] for name in effect.carts):
                press = scene.carts[i].mass * g * math.cos(angle[i])
                high = max(low, n.get("static", low))
                rows.setdefault("rough", []).append((i, low * press, high * press))
    return [(name, listed, piece.SAYS[name]) for name, listed in rows.items()]


def _reduced(scene: Scene, k: int) -> float:
    """kg, of the two bodies of gap k; a wall has infinite mass."""
    near = [scene.carts[i].mass for i in (k - 1, k) if 0 <= i < len(scene.carts)]
    return 1.0 / math.fsum(1.0 / mass for mass in near)


def _step(scene: Scene) -> float:
    """s. A round number."""
    step = scene.until / FEWEST
    for k, contact in enumerate(scene.contacts):
        if contact is not None and contact.stiffness is not None:
            steep = contact.stiffness
            if contact.law == "bumper" and contact.restitution:
                steep /= contact.restitution**2
            step = min(step, 0.5 * math.pi * math.sqrt(_reduced(scene, k) / steep) / PARTS)
    for effect in scene.effects:
        if effect.kind == "spring":
            lightest = min(cart.mass for cart in scene.carts)
            quarter = 0.5 * math.pi * math.sqrt(lightest / 2 / effect.numbers["stiffness"])
            step = min(step, quarter / PARTS)
    return float(f"{max(step, scene.until / MOST_STEPS):.2g}")
