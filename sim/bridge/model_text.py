"""A scene as a program in plain Python, for readers who want to see all of a model, and change it.

It steps (semi-implicit Euler, dt a hundredth of the shortest time in which a force changes what
moves), so it is nearly right where the run is exact; where that would take too many steps, it says
so. It holds only what its scene calls for: each effect and each kind of contact is a piece of text
that is left out where nothing needs it.
"""

from __future__ import annotations

import math
from array import array
from collections.abc import Iterable, Mapping
from importlib import import_module
from textwrap import indent
from typing import Any

from sim.bridge import model_pieces as text_of
from sim.bridge.protocol import plain_of
from sim.dynamics.result.outcome import refuse_written
from sim.effects.plain_model import Piece, piece_of
from sim.laws.contact_law import reduced_mass
from sim.laws.lookup import contact_law
from sim.scene import Scene, read_scene
from sim.scene.effects import kinds
from sim.scene.laws import folder_of

PARTS = 100
"""Steps in a quarter swing, or a fading: the end of a contact is met within a hundredth of it."""

FEWEST, MOST_STEPS = 20_000, 2_000_000
"""Steps of a whole run: fine enough to print, and no longer than some seconds."""


def model_text(scene: Scene) -> str:
    """The program. It prints where the carts are, twenty times, and how fast they end."""
    own = _pieces(scene)
    pieces = [own[kind] for kind in kinds() if kind in own]
    contacts = [contact for contact in scene.contacts if contact is not None]
    rows = _contacts(scene)
    joining = tuple(sorted({contact.law for contact in contacts if contact.joins}))
    sudden = any(contact.sudden for contact in contacts)
    joins = bool(joining) or any(one.joins for one in pieces)
    kicked = joins or sudden
    wanted, dt = _step(scene)
    near = text_of.NEARLY if dt <= wanted else text_of.TOO_LONG.format(dt=dt, wanted=wanted)
    text = text_of.HEAD.format(
        near=near,
        title=" ".join((scene.title or "Carts").split()),
        names=[cart.name for cart in scene.carts],
        mass=[cart.mass for cart in scene.carts],
        x=[cart.position for cart in scene.carts],
        v=[cart.velocity for cart in scene.carts],
        half=[cart.length / 2 for cart in scene.carts],
        end=scene.track.length,
        until=scene.until,
        dt=dt,
        contacts="".join(f"    {row},\n" for row in rows),
    )
    text += _lists(scene, own)
    text += text_of.PLACES
    if kicked:
        text += text_of.KICK
    moves = next((one.move for one in pieces if one.move), "")
    if kicked or moves:
        text += text_of.GROUPS if joins else text_of.ALONE
    text += text_of.STEP
    damped = any(c for *_, c in rows)
    before = "".join(one.contact for one in pieces) + text_of.OF_TEAMS * (joins and damped)
    text += _contact_forces(dict.fromkeys(c.law for c in contacts if not c.sudden), before)
    text += "".join(one.force for one in pieces)
    text += moves or (text_of.MOVE if joins else text_of.MOVE_ALONE)
    text += text_of.IMPACTS.replace("JOINING", repr(joining)) if sudden else ""
    return text + "".join(one.after for one in pieces) + text_of.RUN


def model_answer(request: Mapping[str, Any]) -> tuple[dict[str, Any], array[float]]:
    """The program of the values that the page shows; raises `SceneError`, and `UnsolvedError` of
    a law in a file: its text stands in the page already."""
    scene = read_scene(plain_of(request))
    refuse_written(scene)
    return {"text": model_text(scene)}, array("d")


def _contacts(scene: Scene) -> list[tuple[int | None, int | None, str, float, float, float]]:
    """Left, right, law, k, e and damping c of every pair that may touch. None is a wall."""
    n = len(scene.carts)
    found: list[tuple[int | None, int | None, str, float, float, float]] = []
    for k, contact in enumerate(scene.contacts):
        if contact is None:
            continue
        left, right = (k - 1 if k else None), (k if k < n else None)
        law = contact_law(contact)
        c = 0.0 if law is None else law.damper(_reduced(scene, k))
        e = 0.0 if contact.restitution is None else contact.restitution
        found.append((left, right, contact.law, contact.stiffness or 0.0, e, c))
    return found


def _contact_forces(laws: Iterable[str], before: str) -> str:
    """The force of each law that is there; a law without lines of its own cannot be left out.

    `before`: lines that say where there is none.
    """
    text = ""
    for law in laws:
        size = import_module(f"sim.laws.{folder_of(law)}.model").SIZE
        text += f'        {"elif" if text else "if"} law == "{law}":\n' + indent(size, " " * 12)
    return text_of.CONTACTS + before + text + text_of.PUSH_APART if text else ""


def _pieces(scene: Scene) -> dict[str, Piece]:
    """By kind; those that move the carts themselves last: they may need what others say."""
    pieces = {name: piece_of(name, scene) for name in dict.fromkeys(e.kind for e in scene.effects)}
    return dict(sorted(pieces.items(), key=lambda item: bool(item[1].move)))


def _lists(scene: Scene, pieces: Mapping[str, Piece]) -> str:
    """The lists that the pieces of the effects read."""
    text = ""
    for name, piece in pieces.items():
        own = [effect for effect in scene.effects if effect.kind == name]
        rows = [row for effect in own for row in piece.rows(effect, scene)]
        text += f"{piece.name} = {rows!r}  # {piece.says}\n"
    return text


def _reduced(scene: Scene, k: int) -> float:
    """kg, of the two bodies of gap k; a wall has infinite mass."""
    masses = [math.inf, *(cart.mass for cart in scene.carts), math.inf]
    return reduced_mass(*masses[k : k + 2])


def _step(scene: Scene) -> tuple[float, float]:
    """s. The step that the scene asks for, and the one that is taken: round numbers."""
    step = scene.until / FEWEST
    for k, contact in enumerate(scene.contacts):
        law = None if contact is None else contact_law(contact)
        if law is not None:
            swing = math.sqrt(_reduced(scene, k) / law.steepest)
            step = min(step, 0.5 * math.pi * swing / PARTS)
    for effect in scene.effects:
        shortest = piece_of(effect.kind, scene).shortest
        if shortest is not None:
            step = min(step, shortest(effect, scene) / PARTS)
    least = scene.until / MOST_STEPS
    wanted, taken = (float(f"{one:.2g}") for one in (step, max(step, least)))
    return wanted, taken
