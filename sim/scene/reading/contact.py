"""Contact laws of every neighbourhood: the scene's own, then what `pairs` changes."""

from __future__ import annotations

import itertools
from collections.abc import Mapping
from typing import Any

from sim.scene.fields import Field
from sim.scene.laws import law_kind, laws
from sim.scene.model import Contact, Track
from sim.scene.problem import Path, Problem, did_you_mean, nearest
from sim.scene.said import said
from sim.scene.tables import mapping, unknown_keys

KEYS = ("law", "restitution", "stiffness")
HINT = "contact: {restitution: 0.8, stiffness: 400 N/m, law: bumper}"


def read_contacts(
    value: object, names: list[str] | None, track: Track | None, problems: list[Problem]
) -> tuple[Contact | None, tuple[Contact | None, ...]]:
    """What a gap has that `pairs` leaves alone; the contact of each gap from left to right, None on
    an open side.

    `names` or `track` None: they could not be read, and nobody knows who are neighbours, or where
    there are walls.
    """
    table = mapping(value, ("contact",), problems, HINT)
    if table is None:
        return None, ()
    unknown_keys(table, (*KEYS, "pairs"), ("contact",), problems)
    common = _contact(table, {}, ("contact",), problems)
    bodies = ["left", *(names or ()), "right"]
    contacts = [common] * (len(bodies) - 1)
    pairs = mapping(
        table.get("pairs", {}), ("contact", "pairs"), problems, "pairs: {A-B: {restitution: 0.5}}"
    )
    named: dict[int, str] = {}
    for key, changes in (pairs or {}).items():
        path = ("contact", "pairs", key)
        gap = _gap_named(str(key), bodies)
        if gap is None and names is not None:
            _unknown_pair(str(key), bodies, path, problems)
            continue
        own = mapping(changes, path, problems, "{restitution: 0.5}")
        if own is not None:
            unknown_keys(own, KEYS, path, problems)
            contact = _contact(own, table, path, problems, told=common is None)
            if gap is not None and contact is not None:  # None stands for an open side, and no more
                contacts[gap] = contact
        if gap is not None and (first := named.setdefault(gap, str(key))) != key:
            message = f"“{key}” is the same pair as “{first}”"
            problems.append(Problem(path, "twice", message, "keep one of them"))
    for gap, side in ((0, "left"), (len(contacts) - 1, "right")) if track is not None else ():
        if getattr(track, side) == "open":
            contacts[gap] = None
            if gap in named:
                problems.append(
                    Problem(
                        ("contact", "pairs", named[gap]),
                        "no-wall",
                        f"“{named[gap]}” needs a wall, but the track is open on the {side}",
                        f"track: {{length: 2.4 m, {side}: wall}}, or remove this pair",
                    )
                )
    return common, tuple(contacts)


def _gap_named(key: str, bodies: list[str]) -> int | None:
    """The gap between two neighbours named as ``A-B`` or ``B-A``; names may contain hyphens."""
    for k, (left, right) in enumerate(itertools.pairwise(bodies)):
        if key in (f"{left}-{right}", f"{right}-{left}"):
            return k
    return None


def _unknown_pair(key: str, bodies: list[str], path: Path, problems: list[Problem]) -> None:
    pairs = [f"{a}-{b}" for a, b in itertools.pairwise(bodies)]
    close = nearest(key, pairs)
    hint = f"neighbours: {', '.join(pairs[:12])}"
    if close:
        hint = said("did you mean {name}?", name=f"“{close}”")
    message = said("{pair} are not two neighbours", pair=f"“{key}”")
    problems.append(Problem(path, "unknown-pair", message, hint))


def _contact(
    own: Mapping[str, Any],
    outer: Mapping[str, Any],
    path: Path,
    problems: list[Problem],
    *,
    told: bool = False,
) -> Contact | None:
    """One contact; `own` keys are the author's here, missing ones come from `outer`.

    None where something is wrong, which is then among the problems. `told`: what is wrong in
    `outer` is among them already.
    """
    law = own.get("law", outer.get("law", next(iter(laws()))))
    kind = law_kind(law)
    if kind is None:
        hint = did_you_mean(law, laws(), f"laws: {', '.join(laws())}")
        if path == ("contact",) or "law" in own:
            problems.append(Problem((*path, "law"), "not-a-choice", f"unknown law “{law}”", hint))
        return None
    for key, why in kind.takes_no.items():
        if key in own:
            problems.append(
                Problem(
                    (*path, key),
                    "not-for-this-law",
                    f"{law} {why}: it takes no {key}",
                    f"remove {key}, or use law: bumper",
                )
            )
            return None
    numbers: dict[str, float | None] = {"restitution": None, "stiffness": None}
    for field in (kind.restitution, kind.stiffness):
        if field is not None:
            numbers[field.key] = _value(field, own, outer, path, problems, told=told)
            if numbers[field.key] is None:
                return None
    if kind.no_zero and numbers["restitution"] == 0:
        problems.append(
            Problem(
                (*path, "restitution"),
                "out-of-range",
                f"{law} cannot give restitution 0: {kind.no_zero}",
                "use law: bumper or law: velcro",
            )
        )
        return None
    return Contact(law=law, restitution=numbers["restitution"], stiffness=numbers["stiffness"])


def _value(
    field: Field,
    own: Mapping[str, Any],
    outer: Mapping[str, Any],
    path: Path,
    problems: list[Problem],
    *,
    told: bool,
) -> float | None:
    value = own.get(field.key, outer.get(field.key, field.default))
    if value is None:
        value = "nothing"  # an empty key: reported as not a number, with the example
    inherited = field.key in outer and field.key not in own
    result = field.read(value, (*path, field.key))
    if not isinstance(result, Problem):
        return float(result)
    if not inherited:
        problems.append(result)
    elif not told:  # it fits the scene's own law, and not that of this pair
        message = said("{pair} needs its own {key}", pair=f"“{path[-1]}”", key=said(field.key))
        hint = said("for example {example}", example=f"{field.key}: {field.dimension.example}")
        problems.append(Problem(path, result.code, message, hint))
    return None
