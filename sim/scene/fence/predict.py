"""What a student predicts before a scene may run."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from sim.scene.effects import Effect
from sim.scene.model import Scene
from sim.scene.problem import Path, Problem
from sim.scene.prose import PROSE
from sim.scene.said import said
from sim.scene.tables import mapping, unknown_keys

KINDS = ("arrows", "curve", "choice", "text")
READ = {
    "type": "object",
    "properties": {
        "ask": PROSE,
        "choice": {"type": "array", "items": PROSE},
        "text": PROSE,
    },
}
"""The texts that readers read, as a schema."""
HINT = "predict: {arrows: [A-B]}, {curve: F.A}, {ask: …, choice: [“…”, “…”]} or {text: “…”}"
WISHES = ("talk", "sure")
SCALES = ("relative", "newtons")
Quantity = Literal["F", "v", "x"]
QUANTITIES: tuple[Quantity, ...] = ("F", "v", "x")


@dataclass(frozen=True, slots=True, kw_only=True)
class Predict:
    """A prediction to be locked before the run.

    arrows: length of the force arrow on each cart of the `pairs` at greatest compression.
    curve: a `quantity` of `cart`: the contact force during the contact, velocity or position
    during the run. choice: one of `options`. text: a sentence. `ask` is the question shown above.
    `talk`: after the lock two students compare, and each may change the prediction once before the
    run. `scale`: arrows in newtons, or relative: only which one is longer counts. `sure`: how sure
    the student is, is asked too.
    """

    kind: Literal["arrows", "curve", "choice", "text"]
    ask: str
    pairs: tuple[tuple[str, str], ...] = ()
    cart: str | None = None
    options: tuple[str, ...] = ()
    talk: bool = False
    scale: Literal["relative", "newtons"] = "relative"
    quantity: Quantity = "F"
    sure: bool = False


def read_predict(value: object, scene: Scene, problems: list[Problem]) -> Predict | None:
    """The prediction, or None and a problem. Exactly one of the kinds is named."""
    found = _read_kind(value, scene, problems)
    table = value if isinstance(value, dict) else {}
    for key in WISHES:
        if not isinstance(table.get(key, False), bool):
            path: Path = ("predict", key)
            message = f"{key} is true or false"
            problems.append(Problem(path, "not-a-choice", message, f"{key}: true"))
    talk, sure = (table.get(key) is True for key in WISHES)
    scale = table.get("scale", "relative")
    if scale not in SCALES:
        message = "scale is relative (which arrow is longer?) or newtons"
        problems.append(Problem(("predict", "scale"), "not-a-choice", message, "scale: newtons"))
    return found and replace(found, talk=talk, scale=scale, sure=sure)


def kind_of(value: object, problems: list[Problem]) -> tuple[str, Mapping[str, Any]] | None:
    """Which kind of prediction is asked for, and its table: what can be told without the scene."""
    path: Path = ("predict",)
    table = mapping(value, path, problems, HINT)
    if table is None:
        return None
    told, meant = len(problems), {"options": "did you mean “choice”?"}
    unknown_keys(table, (*KINDS, "ask", "scale", *WISHES), path, problems, elsewhere=meant)
    kinds = [kind for kind in KINDS if kind in table]
    if not kinds and len(problems) > told:  # it has another name there
        return None
    if len(kinds) != 1:
        problems.append(Problem(path, "not-a-choice", "predict names exactly one kind", HINT))
        return None
    ask = table.get("ask")
    if ask is not None and not isinstance(ask, str):
        problems.append(Problem((*path, "ask"), "not-text", "ask must be text", HINT))
        return None
    return kinds[0], table


def _read_kind(value: object, scene: Scene, problems: list[Problem]) -> Predict | None:
    path: Path = ("predict",)
    found = kind_of(value, problems)
    if found is None:
        return None
    kind, table = found
    body, ask = table[kind], table.get("ask")
    if kind == "arrows":
        return _arrows(body, ask, scene, (*path, kind), problems)
    if kind == "curve":
        return _curve(body, ask, scene, (*path, kind), problems)
    if kind == "choice":
        if (
            not isinstance(body, (list, tuple))
            or len(body) < 2
            or not all(isinstance(option, str) and option.strip() for option in body)
        ):
            problems.append(
                Problem((*path, kind), "not-a-list", "choice lists two or more texts", HINT)
            )
            return None
        _all_differ(body, (*path, kind), problems)
        return Predict(kind="choice", ask=ask or said("What will happen?"), options=tuple(body))
    if not isinstance(body, str) or not body.strip():
        problems.append(Problem((*path, kind), "not-text", "text is the question to answer", HINT))
        return None
    return Predict(kind="text", ask=body)


def _all_differ(options: Sequence[str], path: Path, problems: list[Problem]) -> None:
    """Two buttons with one text cannot be told apart, nor can what was predicted."""
    plain = [" ".join(option.split()) for option in options]
    for k, option in enumerate(plain):
        if option in plain[:k]:
            problems.append(Problem((*path, k), "twice", "this answer stands there twice", HINT))


def _arrows(
    body: object, ask: str | None, scene: Scene, path: Path, problems: list[Problem]
) -> Predict | None:
    neighbours = [
        scene.names_at(k) for k, contact in enumerate(scene.contacts) if contact is not None
    ]
    names = {f"{a}-{b}": (a, b) for a, b in neighbours}
    wanted = body if isinstance(body, (list, tuple)) else [body]
    if body in (True, "all", None):
        wanted = [key for key, pair in names.items() if not {"left", "right"} & set(pair)]
    pairs = [names.get(str(key)) for key in wanted]
    if not pairs or None in pairs:
        strange = wanted[pairs.index(None)] if pairs else ""
        named = "" if isinstance(strange, (dict, list, tuple)) else str(strange)
        problems.append(_no_pair(named, names, path))
        return None
    known = [pair for pair in pairs if pair is not None]
    lasting = for_a_time(scene, scene.effects)
    sudden = next((pair for pair in known if pair not in lasting), None)
    if sudden:
        a, b = sudden
        message = f"{a} and {b} push each other at one instant: their force has no size to predict"
        hint = "predict velocities, or take a contact with a duration: law: bumper"
        problems.append(Problem(path, "not-for-this-law", message, hint))
        return None
    return Predict(
        kind="arrows",
        ask=ask or said("How long is each force arrow when the two push hardest on each other?"),
        pairs=tuple(known),
    )


def for_a_time(scene: Scene, effects: Iterable[Effect]) -> set[tuple[str, str]]:
    """Neighbours that may push each other for a time, not at one instant alone, by a contact or by
    one of these effects."""
    lasting = {scene.names_at(k) for k, one in enumerate(scene.contacts) if one and not one.sudden}
    return lasting | {effect.between for effect in effects if effect.between}


def _no_pair(key: str, names: Mapping[str, tuple[str, str]], path: Path) -> Problem:
    """Why `key` is no pair of this scene, and which pairs it has; empty: none was listed."""
    if not names:
        message = "nothing can touch anything here, so there is no force to predict"
        return Problem(path, "no-contact", message, "another cart, or a wall for a cart to meet")
    pairs = f"arrows: [{', '.join(names)}]"
    if not key:
        return Problem(path, "unknown-pair", "arrows lists pairs of neighbours", pairs)
    turned = [name for name, (a, b) in names.items() if key == f"{b}-{a}"]
    if turned:
        message = f"“{key}” names two neighbours from right to left"
        return Problem(path, "unknown-pair", message, f"from left to right: arrows: [{turned[0]}]")
    message = said("{pair} are not two neighbours", pair=f"“{key}”")
    return Problem(path, "unknown-pair", message, f"neighbours here: {pairs}")


def _curve(
    body: object, ask: str | None, scene: Scene, path: Path, problems: list[Problem]
) -> Predict | None:
    name, _, cart = str(body).partition(".")
    quantity = next((q for q in QUANTITIES if q == name), None)
    if quantity is None or cart not in {c.name for c in scene.carts}:
        first = scene.carts[0].name
        hint = f"curve: F.{first} (force), v.{first} (velocity) or x.{first} (position)"
        problems.append(Problem(path, "unknown-path", f"no curve “{body}”", hint))
        return None
    if quantity == "F" and not any(scene.contacts):
        message = f"nothing can touch {cart}: there is no contact force to predict"
        hint = f"curve: v.{cart}, or another cart or a wall for it to meet"
        problems.append(Problem(path, "no-contact", message, hint))
        return None
    if quantity == "F" and not any(cart in two for two in for_a_time(scene, scene.effects)):
        message = f"nothing pushes {cart} for a time here: its force has no course to predict"
        hint = f"curve: v.{cart}, or a contact with a duration: law: bumper"
        problems.append(Problem(path, "not-for-this-law", message, hint))
        return None
    asks = {
        "F": said("How does the force on {cart} change while they touch?", cart=cart),
        "v": said("How does the velocity of {cart} change from start to end?", cart=cart),
        "x": said("How does the position of {cart} change from start to end?", cart=cart),
    }
    return Predict(kind="curve", cart=cart, quantity=quantity, ask=ask or asks[quantity])
