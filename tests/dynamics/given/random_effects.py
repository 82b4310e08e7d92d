"""Random scenes in which effects act: every kind, alone and mixed, on the rows of `random rows`."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from hypothesis import assume
from hypothesis import strategies as st

from tests.dynamics.given.random_rows import decimals, scenes
from tests.one_slope import one_slope

KINDS = ("friction", "incline", "drag", "push", "spring", "magnets", "release")
ELASTIC = st.fixed_dictionaries(
    {
        "law": st.sampled_from(["bumper", "paper", "push-only", "instant"]),
        "restitution": st.just(1),
    }
).map(lambda c: c if c["law"] == "instant" else c | {"stiffness": 400})
"""Contacts that warm nothing."""

ROOM = 0.002
"""m. Magnets at no room push with no limit: they are only put where there is some."""


def bodies_of(plain: dict[str, Any]) -> list[str]:
    """Walls and carts from left to right."""
    track = plain["track"]
    return [
        *(["left"] if track["left"] == "wall" else []),
        *sorted(plain["carts"], key=lambda name: float(plain["carts"][name]["position"])),
        *(["right"] if track["right"] == "wall" else []),
    ]


def rooms_of(plain: dict[str, Any]) -> list[float]:
    """m. Edge to edge between the neighbours of `bodies_of`."""
    edges = []
    for name in bodies_of(plain):
        if name in plain["carts"]:
            centre = float(plain["carts"][name]["position"])
            edges.append((centre - 0.1, centre + 0.1))
        else:
            wall = 0.0 if name == "left" else float(plain["track"]["length"])
            edges.append((wall, wall))
    return [b[0] - a[1] for a, b in pairwise(edges)]


@st.composite
def some_carts(draw: st.DrawFn, plain: dict[str, Any]) -> dict[str, Any]:
    """All carts, or a few."""
    names = sorted(plain["carts"])
    if draw(st.booleans()):
        return {}
    return {"carts": draw(st.lists(st.sampled_from(names), min_size=1, unique=True))}


@st.composite
def effect(draw: st.DrawFn, plain: dict[str, Any], kinds: tuple[str, ...]) -> dict[str, Any]:
    """One entry of the list of effects, fit for the scene."""
    bodies, rooms = bodies_of(plain), rooms_of(plain)
    inner = [k for k, a in enumerate(bodies[:-1]) if {a, bodies[k + 1]} <= set(plain["carts"])]
    wide = [k for k, room in enumerate(rooms) if room >= ROOM]
    possible = [
        kind
        for kind in kinds
        if not (kind == "spring" and not rooms)
        and not (kind == "magnets" and not wide)
        and not (kind == "release" and not inner)
    ]
    assume(possible)
    kind = draw(st.sampled_from(possible))
    body: dict[str, Any] = {}
    if kind == "friction":
        body["coefficient"] = draw(st.sampled_from(["0", "0.02", "0.1", "0.3"]))
        if draw(st.booleans()):
            body["static"] = f"{float(body['coefficient']) * 1.5:.3f}"
        body |= draw(some_carts(plain))
    elif kind == "incline":
        body["angle"] = draw(st.one_of(st.sampled_from(["2 deg", "-5 deg"]), decimals(-0.3, 0.3)))
        body |= draw(some_carts(plain))
    elif kind == "drag":
        which = draw(st.sampled_from([("linear",), ("quadratic",), ("linear", "quadratic")]))
        body = {key: draw(st.sampled_from(["0.05", "0.5", "3"])) for key in which}
        body |= draw(some_carts(plain))
    elif kind == "push":
        body["cart"] = draw(st.sampled_from(sorted(plain["carts"])))
        body["force"] = draw(st.one_of(st.sampled_from(["1", "-1"]), decimals(-5, 5, 2)))
        if draw(st.booleans()):
            begin = float(draw(decimals(0, 1, 2)))
            body |= {"from": begin, "until": begin + float(draw(decimals(0.05, 1, 2)))}
    else:
        places = range(len(rooms)) if kind == "spring" else wide if kind == "magnets" else inner
        k = draw(st.sampled_from(list(places)))
        body["between"] = [bodies[k], bodies[k + 1]]
        if kind == "spring":
            body["stiffness"] = draw(st.sampled_from(["5", "40", "800"]))
            body["length"] = draw(st.one_of(st.just("0"), decimals(0, 0.3)))
            body["damping"] = draw(st.sampled_from(["0", "0.3", "8"]))
        elif kind == "magnets":
            body["strength"] = draw(st.sampled_from(["1e-6", "1e-3", "0.05"]))
            body["power"] = draw(st.sampled_from(["1", "2", "3", "2.5", "4"]))
        else:
            body["energy"] = draw(st.sampled_from(["0.1", "1"]))
            body["at"] = draw(st.sampled_from(["0", "0.2"]))
            if draw(st.booleans()) and rooms[k] >= 0:
                body["stiffness"] = draw(st.sampled_from(["5", "40", "800"]))
    return {kind: body}


@st.composite
def acted_on(
    draw: st.DrawFn,
    kinds: tuple[str, ...] = KINDS,
    *,
    overlaps: bool = True,
    most: int = 3,
    walls: bool = True,
    contact: st.SearchStrategy[dict[str, Any]] | None = None,
) -> dict[str, Any]:
    """A random row with one to `most` effects; sometimes it starts with an overlap.

    `contact` replaces the laws of the row.
    """
    plain = draw(scenes())
    if not walls:
        plain["track"] |= {"left": "open", "right": "open"}
        pairs = plain["contact"].get("pairs", {})
        if any({"left", "right"} & set(name.split("-")) for name in pairs):
            del plain["contact"]["pairs"]
    if contact is not None:
        plain["contact"] = draw(contact)
    count = draw(st.integers(1, most))
    plain["effects"] = one_slope([draw(effect(plain, kinds)) for _ in range(count)])
    gaps = len(plain["carts"]) - 1
    magnetic = {tuple(e["magnets"]["between"]) for e in plain["effects"] if "magnets" in e}
    soft = not {"instant", "velcro"} & set(str(plain["contact"]).split("'"))
    if overlaps and soft and gaps and not magnetic and draw(st.integers(0, 4)) == 0:
        first = draw(st.integers(1, gaps))
        room = rooms_of(plain)[first - 1 + (plain["track"]["left"] == "wall")]
        closer = room + float(draw(decimals(0, 0.02)))
        for k in range(first, gaps + 1):
            cart = plain["carts"][f"c{k}"]
            cart["position"] = f"{float(cart['position']) - closer:.6f}"
        plain["start"] = {"overlap": True}
        for entry in plain["effects"]:  # a spring needs two that just touch
            entry.get("release", {}).pop("stiffness", None)
    return plain
