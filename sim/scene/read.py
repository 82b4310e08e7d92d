"""From plain values to a Scene, or to every problem in them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sim.scene.effects import kinds
from sim.scene.fields import CART, GRAVITY, IN_OTHER_WORDS, SKINS, TRACK_LENGTH, UNTIL
from sim.scene.model import Cart, Scene
from sim.scene.problem import Path, Problem, SceneError, meant, nearest
from sim.scene.reading.contact import read_contacts
from sim.scene.reading.effects import check_room, read_effects, read_estimates
from sim.scene.reading.gaps import approaches, gaps_of, refuse_overlap
from sim.scene.reading.written import read_written
from sim.scene.said import said
from sim.scene.tables import mapping, number, unknown_keys
from sim.scene.track import read_track

SCENE_KEYS = (
    *("title", "carts", "track", "contact", "effects", "until", "gravity", "start"),
    *("estimate", "laws"),
)
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]{0,15}", re.ASCII)
WALLS = ("left", "right")
YAML_WORDS = ("null", "true", "false", "yes", "no", "on", "off")
"""What YAML reads as nothing, or as true or false: in small letters, in capitals or like a name."""

MOST_CARTS = 100_000
"""More carts than this are refused before work starts: a run of them would not fit a laptop."""


def read_scene(plain: object) -> Scene:
    """The scene that `plain` (nested dicts, lists, numbers, texts) describes; raises SceneError."""
    problems: list[Problem] = []
    scene = collect_scene(plain, problems)
    if problems or scene is None:
        raise SceneError(problems)
    return scene


def collect_scene(plain: object, problems: list[Problem]) -> Scene | None:
    """Like `read_scene`, but appends what it finds to `problems`."""
    before = len(problems)
    table = mapping(plain, (), problems, "a scene is a table of keys, for example “carts:”")
    if table is None:
        return None
    unknown_keys(table, SCENE_KEYS, (), problems)
    exact = _carts(table.get("carts"), problems)
    track, length = read_track(table.get("track", {}), problems)
    title = table.get("title")
    if title is not None and not isinstance(title, str):
        problems.append(Problem(("title",), "not-text", "the title must be text", "title: A crash"))
    until = number(UNTIL, table, (), problems)
    gravity = number(GRAVITY, table, (), problems)
    overlap_allowed = _start(table.get("start", {}), problems)
    if len(problems) > before or exact is None or track is None or until is None or gravity is None:
        neighbours = None if exact is None else sorted_names(exact)
        read_contacts(table.get("contact", {}), neighbours, track, problems)
        if track is not None:  # what is wrong with the effects is told in the same reading
            read_effects(table.get("effects", []), _written_names(table), track, problems)
        return None
    names = sorted_names(exact)
    common, contacts = read_contacts(table.get("contact", {}), names, track, problems)
    written = read_written(table.get("laws", {}), table.get("contact", {}), contacts, problems)
    effects = read_effects(table.get("effects", []), names, track, problems)
    estimates = read_estimates(table.get("estimate", []), names, track, problems)
    released = {frozenset(e.between) for e in effects if kinds()[e.kind].overlap and e.between}
    gaps = gaps_of(exact, names, track, length)
    for k, gap in enumerate(gaps):
        if gap is None or gap >= 0:
            continue
        contact = contacts[k] if k < len(contacts) else None
        at_once = contact is not None and contact.sudden
        if at_once or not overlap_allowed:  # without a duration there is nothing to be pressed in
            refuse_overlap(k, gap, names, track, released, problems, at_once=at_once)
    if len(problems) == before:
        check_room(effects, gaps, names, problems)
    if len(problems) > before:
        return None
    return Scene(
        title=title if isinstance(title, str) else None,
        carts=tuple(Cart(name=n, **{k: float(v) for k, v in exact[n].items()}) for n in names),
        track=track,
        common=common,
        contacts=contacts,
        gaps=tuple(float("inf") if gap is None else float(gap) for gap in gaps),
        approaches=approaches(exact, names, track),
        effects=effects,
        estimates=estimates,
        tolerances=_tolerances(table),
        written=written,
        until=float(until),
        gravity=float(gravity),
    )


def _tolerances(table: Mapping[str, Any]) -> dict[str, Fraction]:
    """Half widths, SI, of what has one; the scene has been read, so that all of it makes sense."""
    found = {
        f"{name}.{field.key}": field.half_width(cart.get(field.key))
        for name, cart in table["carts"].items()
        for field in CART
    }
    track = table.get("track", {})
    found[f"track.{TRACK_LENGTH.key}"] = TRACK_LENGTH.half_width(track.get(TRACK_LENGTH.key))
    return {path: half for path, half in found.items() if half}


def sorted_names(exact: Mapping[str, Mapping[str, Fraction]]) -> list[str]:
    """Cart names from left to right; carts at one place in the order of their names."""
    return sorted(exact, key=lambda name: (exact[name]["position"], name))


def _written_names(table: Mapping[str, Any]) -> list[str]:
    """The names of the carts as they stand there, also of carts with mistakes."""
    carts = table.get("carts")
    return sorted(filter(names_a_cart, carts)) if isinstance(carts, Mapping) else []


def names_a_cart(text: object) -> bool:
    """Whether a cart may be called so: a short word that is neither a wall nor YAML's own."""
    if not isinstance(text, str) or not NAME.fullmatch(text) or text in WALLS:
        return False
    as_yaml = text in (text.lower(), text.upper(), text.capitalize())
    return not (as_yaml and text.lower() in YAML_WORDS)


def _carts(value: object, problems: list[Problem]) -> dict[str, dict[str, Fraction]] | None:
    hint = "carts: {A: {mass: 1 kg, position: 0.40 m, velocity: 0.60 m/s}}"
    table = mapping(value, ("carts",), problems, hint)
    if table is None:
        return None
    if not table or len(table) > MOST_CARTS:
        message = "a scene needs a cart" if not table else f"more than {MOST_CARTS} carts"
        problems.append(Problem(("carts",), "wrong-count", message, hint))
        return None
    before = len(problems)
    carts: dict[str, dict[str, Fraction]] = {}
    for name, body in table.items():
        path = ("carts", name)
        if not names_a_cart(name):
            problems.append(
                Problem(
                    path,
                    "bad-name",
                    f"“{str(name)[:40]}” cannot name a cart",
                    "use a letter (a to z), then up to 15 letters, digits, - or _; "
                    "“left” and “right” are the walls, “null” means nothing, "
                    "“true”, “yes”, “on” and the like are no names in YAML",
                )
            )
            continue
        cart = mapping(body, path, problems, "{mass: 1 kg, position: 0.40 m}")
        if cart is not None:
            carts[name] = _cart(cart, path, problems)
    return None if len(problems) > before else carts


def _cart(table: Mapping[str, Any], path: Path, problems: list[Problem]) -> dict[str, Fraction]:
    keys = tuple(field.key for field in CART)
    everyday = {word: meant(key) for word, key in IN_OTHER_WORDS.items()}
    unknown_keys(table, (*keys, "skin"), path, problems, elsewhere=everyday)
    if (skin := table.get("skin", SKINS[0])) not in SKINS:
        message = f"no skin “{str(skin)[:40]}”"
        close, listed = nearest(str(skin), SKINS), ", ".join(SKINS)
        hint = f"one of {listed}"
        if close:
            hint = said("did you mean {name}? There are {names}", name=f"“{close}”", names=listed)
        problems.append(Problem((*path, "skin"), "not-a-choice", message, hint))
    misspelt = {
        IN_OTHER_WORDS.get(str(key)) or nearest(str(key), keys) for key in table if key not in keys
    }
    exact = {}
    for field in CART:
        if field.key not in table and field.key in misspelt and field.default is None:
            continue  # misspelt, and already told so
        value = number(field, table, path, problems)
        if value is not None:
            exact[field.key] = value
    length, bumper = exact.get("length"), exact.get("bumper_length")
    if length is not None and bumper is not None and 2 * bumper > length:
        if "bumper_length" in table:
            problems.append(
                Problem(
                    (*path, "bumper_length"),
                    "out-of-range",
                    f"two bumpers of {float(bumper):g} m do not fit a cart of {float(length):g} m",
                    f"bumper_length: at most half the length, {float(length / 2):g} m",
                )
            )
        exact["bumper_length"] = length / 2
    return exact


def _start(value: object, problems: list[Problem]) -> bool:
    table = mapping(value, ("start",), problems, "start: {overlap: true}")
    if table is None:
        return False
    unknown_keys(table, ("overlap",), ("start",), problems)
    overlap = table.get("overlap", False)
    if not isinstance(overlap, bool):
        problems.append(
            Problem(
                ("start", "overlap"),
                "not-a-choice",
                "overlap must be true or false",
                "start: {overlap: true}",
            )
        )
    return overlap is True
