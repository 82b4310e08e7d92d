"""The plainest scene that goes wrong in the same way: what can be left out is left out."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from copy import deepcopy

from tests.fuzz.rows import Plain
from tests.fuzz.verdict import Verdict, judge

MOST_TRIES = 120
"""Scenes tried for one that is found; each may take the whole budget."""


def plainest(plain: Plain, found: Verdict) -> Plain:
    """Try everything that makes the scene plainer, as long as the verdict stays the same word."""
    tries = 0
    changed = True
    while changed and tries < MOST_TRIES:
        changed = False
        for other in plainer(plain):
            tries += 1
            if judge(other, oracle=found.word in ("end", "mirror")).word == found.word:
                plain, changed = other, True
                break
            if tries >= MOST_TRIES:
                break
    return plain


def plainer(plain: Plain) -> Iterator[Plain]:
    """Scenes with one thing less, or one number nicer."""
    for k in range(len(plain.get("effects", []))):
        other = deepcopy(plain)
        del other["effects"][k]
        yield other
    for name in plain["carts"]:
        if len(plain["carts"]) > 1:
            yield without_cart(plain, name)
    for side in ("left", "right"):
        if plain.get("track", {}).get(side) == "wall":
            other = deepcopy(plain)
            other["track"][side] = "open"
            _prune(other)
            yield other
    for name in plain["contact"].get("pairs", {}):
        other = deepcopy(plain)
        del other["contact"]["pairs"][name]
        if not other["contact"]["pairs"]:
            del other["contact"]["pairs"]
        yield other
    if plain["until"] > 1:
        yield deepcopy(plain) | {"until": 1}
    for name, cart in plain["carts"].items():
        for key, nice in (("mass", 1.0), ("velocity", 0.0), ("velocity", 1.0)):
            if cart.get(key) != nice and not (key == "velocity" and cart[key] == 0.0):
                other = deepcopy(plain)
                other["carts"][name][key] = nice
                yield other


def without_cart(plain: Plain, name: str) -> Plain:
    """The scene without a cart, and without what speaks of it."""
    other = deepcopy(plain)
    del other["carts"][name]
    _prune(other)
    return other


def _prune(plain: Plain) -> None:
    carts = list(plain["carts"])
    track = plain.get("track", {})
    row = [*(["left"] if track.get("left") == "wall" else []), *carts]
    row += ["right"] if track.get("right") == "wall" else []
    beside = {f"{a}-{b}" for a, b in itertools.pairwise(row)}
    pairs = {k: v for k, v in plain["contact"].get("pairs", {}).items() if k in beside}
    plain["contact"].pop("pairs", None)
    if pairs:
        plain["contact"]["pairs"] = pairs
    kept = []
    for entry in plain.get("effects", []):
        ((_, body),) = entry.items()
        named = [*body.get("carts", []), *([body["cart"]] if "cart" in body else [])]
        between = body.get("between")
        if all(n in carts for n in named) and (between is None or "-".join(between) in beside):
            kept.append(entry)
    if "effects" in plain:
        plain["effects"] = kept
