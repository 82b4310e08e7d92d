"""An effect's part of a scene written as a program in plain Python.

The program keeps a list per kind (`name = [row, …]  # says`) and reads it in `step()`, where
`force[i]`, `v[i]`, `t`, `gap(left, right)`, `approach(left, right)` and `push_apart(force, left,
right, size)` are at hand. What a piece leaves empty is left out.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

from sim.scene.effects import Effect
from sim.scene.model import Scene

Row = tuple[object, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Piece:
    """`rows` gives an effect's entries of the list; the texts are lines of the program.

    `contact` stands in the loop over the contacts, where the overlap d, its rate s and the number k
    of one are known, before its force. `force` adds to the forces of a step. `move` takes the place
    of the lines that move the carts. `after` stands at the end of the step, with what it needs
    after it. `joins`: carts may move as one. `shortest` [s]: the shortest time in which its force
    changes what moves (a quarter swing, a fading), which the program's step has to resolve.
    """

    name: str
    says: str
    rows: Callable[[Effect, Scene], list[Row]]
    contact: str = ""
    force: str = ""
    move: str = ""
    after: str = ""
    joins: bool = False
    shortest: Callable[[Effect, Scene], float] | None = None


def piece_of(kind: str, scene: Scene) -> Piece:
    """The piece of one kind of effect: PIECE, or what `piece` makes for a scene. Raises ImportError
    where its folder has none."""
    model = import_module(f"sim.effects.{kind}.model")
    make = getattr(model, "piece", None)
    found = getattr(model, "PIECE", None) if make is None else make(scene)
    if not isinstance(found, Piece):
        raise ImportError(f"sim.effects.{kind}.model holds no PIECE")
    return found
