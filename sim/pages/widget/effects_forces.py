"""Forces of effects on single carts: which ones, by whom, and where their arrows stand.

Twin: `sim/web/src/effects-forces.js`. Under the track every force has a row of its own, tail below
the middle of its cart, so that forces on one cart can be compared: equal and opposite, or not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sim.pages.language import heard, tr
from sim.pages.widget.numbers import decimals_for, fixed
from sim.pages.widget.run import Run, value_at
from sim.pages.widget.words import listed

ON_ONE = ("incline", "push", "friction", "drag")  # in this order from above to below
ROW = 19.0  # units
FEW = 3  # carts; with more, all forces of one kind share a row


def agent(effect: Mapping[str, Any]) -> str:
    """Who or what the force of an effect comes from, as a sentence names it."""
    names = {"friction": tr("the track"), "drag": tr("the air"), "incline": tr("the Earth")}
    return names.get(effect["kind"]) or heard(str(effect["by"]))


def slots(header: Mapping[str, Any], top: float) -> dict[str, float]:
    """y of the row of each force, by “kind cart”, from `top` downwards; what is off counts too."""
    many = len(header["bodies"]) > FEW
    rows: dict[str, float] = {}
    row = 0
    for kind in ON_ONE:
        acted_on = {name for e in header["effects"] if e["kind"] == kind for name in e["carts"]}
        names = [body["name"] for body in header["bodies"] if body["name"] in acted_on]
        for name in names:
            rows[f"{kind} {name}"] = top + ROW * (row + 0.5)
            row += 0 if many else 1
        row += 1 if many and names else 0
    return rows


def rows_of(slots: Mapping[str, float]) -> int:
    """How many rows there are."""
    return len(set(slots.values()))


def acts_at(effect: Mapping[str, Any], t: float) -> bool:
    """Whether an effect acts at t (s); a push does from its beginning to its end."""
    if not effect["active"]:
        return False
    begin, end = effect["numbers"].get("from", 0.0), effect["numbers"].get("until")
    return effect["kind"] != "push" or (t >= begin and (end is None or t < end))


def forces_at(header: Mapping[str, Any], run: Run, t: float) -> list[dict[str, Any]]:
    """Every force of an effect on one cart at t: kind, cart `on`, `by`, N (+ right), its text."""
    found = []
    for kind in ON_ONE:
        acting = [e for e in header["effects"] if e["kind"] == kind and acts_at(e, t)]
        for body in header["bodies"]:
            name = body["name"]
            own = [effect for effect in acting if name in effect["carts"]]
            column = run.effects.get(f"{kind} {name}")
            if not own or not column:
                continue
            by = listed(list(dict.fromkeys(agent(effect) for effect in own)))
            peak = max(map(abs, column))
            value = value_at(run.t, column, None, t)
            value = 0.0 if abs(value) <= 1e-9 * peak else value
            size = fixed(abs(value), decimals_for(peak or 1.0)) if value else "0"
            found.append({"kind": kind, "on": name, "by": by, "value": value, "size": size})
    return found


def labels(force: Mapping[str, Any]) -> list[str]:
    """What may stand beside an arrow: “on A by the track: 0.10 N”, and shorter forms of it.

    The shortest leaves the cart to the colour and to the line from it.
    """
    told = {"on": force["on"], "by": force["by"], "size": force["size"]}
    brief = {**told, "by": force["by"].replace("the ", "")}
    if force["kind"] == "incline":
        longest = tr("on {on} by {by} (slope): {size} N", **told)
    else:
        longest = tr("on {on} by {by}: {size} N", **told)
    return [longest, tr("on {on} by {by}: {size} N", **brief), tr("by {by}: {size} N", **brief)]


def outside(header: Mapping[str, Any]) -> str:
    """What gets the momentum that the carts give away: “wall + Earth”, “air”; “” where nothing."""
    walls = "wall" in (header["track"]["left"], header["track"]["right"])
    kinds = {effect["kind"] for effect in header["effects"]}
    parts = [tr("wall")] if walls else []
    parts += [tr("track")] if "friction" in kinds else []
    parts += [tr("air")] if "drag" in kinds else []
    parts += [agent(effect) for effect in header["effects"] if effect["kind"] == "push"]
    parts += [tr("Earth")] if walls or kinds & {"friction", "incline"} else []
    return " + ".join(dict.fromkeys(parts))


def linked_pairs(header: Mapping[str, Any]) -> Sequence[str]:
    """Pairs, such as A-B, that push or pull each other without touching."""
    return [
        "-".join(effect["between"])
        for effect in header["effects"]
        if effect["kind"] in ("spring", "magnets")
    ]
