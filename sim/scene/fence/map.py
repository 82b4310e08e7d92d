"""A `map` fence: one outcome of a scene over one or two of its numbers.

over:
  - {set: A.mass, from: 0.5 kg, to: 5 kg}
  - {set: contact.restitution, from: 0, to: 1}
show: v.A | F.A-B | warmed
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal

from sim.scene.fence.controls import Control, Kind, read_control, read_controls
from sim.scene.fence.presentation import ID
from sim.scene.model import Scene
from sim.scene.problem import Path, Problem, SceneError
from sim.scene.quantity import unit_of
from sim.scene.read import SCENE_KEYS, collect_scene
from sim.scene.said import said, template
from sim.scene.tables import mapping, unknown_keys
from sim.scene.track import body_name

MAP_KEYS = ("id", "of", "over", "show", "points", "controls")
MOST_CONTROLS = 2
FEWEST, USUAL, MOST = 2, 200, 400
"""Points along one axis."""

OVER_HINT = "over:\n  - {set: A.mass, from: 0.5 kg, to: 5 kg}"
ORDER_HINT = "the smaller one stands behind from: {set: A.mass, from: 0.5 kg, to: 5 kg}"
AXIS = Kind(
    name="axis",
    limits="from: …, to: …",
    order="an axis goes from a smaller to a larger number",
    order_hint=lambda _: ORDER_HINT,
)
SHOW_HINT = "show: v.A (final velocity), F.A-B (greatest force) or warmed (energy)"


@dataclass(frozen=True, slots=True, kw_only=True)
class Shown:
    """What a map shows: the kind and what it is of, its name in words, and its SI unit."""

    kind: Literal["v", "F", "warmed"]
    of: str
    label: str
    unit: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Map:
    """A map as a lesson shows it. `values` are the points of each axis in SI.

    `of` names the scene on the same page that a point can be run in; `plain` are the scene's keys.
    """

    id: str
    of: str | None
    title: str | None
    scene: Scene
    plain: Mapping[str, Any]
    over: tuple[Control, ...]
    values: tuple[tuple[float, ...], ...]
    show: Shown
    controls: tuple[Control, ...]


def read_map(plain: object) -> Map:
    """The map that `plain` describes, its scene's keys included; raises SceneError."""
    problems: list[Problem] = []
    table = mapping(plain, (), problems, "a map is a table of keys, for example “over:”")
    if table is None:
        raise SceneError(problems)
    unknown_keys(table, (*MAP_KEYS, *SCENE_KEYS), (), problems)
    scene_part = {key: value for key, value in table.items() if key in SCENE_KEYS}
    scene = collect_scene(scene_part, problems)
    identity = _identity("id", table, problems, needed=True)
    of = _identity("of", table, problems, needed=False)
    points = _points(table.get("points"), problems)
    if scene is None:
        raise SceneError(problems)
    over = _over(table.get("over"), scene, problems)
    show = _show(table.get("show"), scene, problems)
    controls = read_controls(table.get("controls", []), scene, problems)
    _refuse_more(controls, over, problems)
    if problems or show is None or not over:
        raise SceneError(problems)
    return Map(
        id=identity,
        of=of or None,
        title=scene.title,
        scene=scene,
        plain=scene_part,
        over=over,
        values=tuple(_values(control, points) for control in over),
        show=show,
        controls=controls,
    )


def _identity(key: str, table: Mapping[str, Any], problems: list[Problem], *, needed: bool) -> str:
    value = table.get(key)
    if key not in table and not needed:
        return ""
    if isinstance(value, str) and ID.fullmatch(value):
        return value
    missing = key not in table
    message = f"{key} is missing" if missing else f"“{str(value)[:40]}” cannot be an id"
    hint = "small letters, digits and hyphens, one of its kind in the whole site: id: mass-map"
    if key == "of":
        hint = "the id of a scene on this page: of: light-meets-heavy"
    path: Path = () if missing else (key,)
    problems.append(Problem(path, "missing" if missing else "bad-name", message, hint))
    return ""


def _points(value: object, problems: list[Problem]) -> int | None:
    if value is None:
        return None
    number = int(value) if isinstance(value, str) and value.isdecimal() else value
    if isinstance(number, bool) or not isinstance(number, int) or not FEWEST <= number <= MOST:
        message = f"points is a whole number from {FEWEST} to {MOST} (got {str(value)[:40]})"
        problems.append(Problem(("points",), "out-of-range", message, "points: 200"))
        return None
    return number


def _over(value: object, scene: Scene, problems: list[Problem]) -> tuple[Control, ...]:
    """The axes. An axis is a control without steps: its numbers are read as those of a control."""
    path: Path = ("over",)
    if not isinstance(value, (list, tuple)) or not 1 <= len(value) <= 2:
        code = "missing" if value is None else "wrong-count"
        message = "over lists one or two numbers of the scene to vary"
        problems.append(Problem(() if value is None else path, code, message, OVER_HINT))
        return ()
    axes: list[Control] = []
    for k, entry in enumerate(value):
        table = mapping(entry, (*path, k), problems, OVER_HINT)
        if table is None:
            continue
        unknown_keys(table, ("set", "from", "to"), (*path, k), problems)
        control = _as_control(table)
        axis = read_control(control, (*path, k), scene, scene.effects, problems, AXIS)
        axes += [] if axis is None else [axis]
    if len(axes) == 2 and axes[0].set == axes[1].set:
        message = f"{axes[0].set} stands here twice"
        problems.append(Problem((*path, 1, "set"), "twice", message, OVER_HINT))
    return tuple(axes)


def _as_control(table: Mapping[str, Any]) -> dict[str, Any]:
    """With any step, in the unit of the axis."""
    given = {key: table[key] for key in ("set", "from", "to") if key in table}
    units = [unit_of(str(given[key])) for key in ("from", "to") if key in given]
    return {**given, "step": f"1 {next(filter(None, units), '')}".strip()}


def _show(value: object, scene: Scene, problems: list[Problem]) -> Shown | None:
    def refuse(code: str, message: str, hint: str = SHOW_HINT) -> None:
        problems.append(Problem(() if value is None else ("show",), code, message, hint))

    if value is None:
        refuse("missing", "show is missing")
        return None
    kind, _, of = str(value).partition(".")
    if value == "warmed":
        return Shown(
            kind="warmed", of="", label=template("energy that warmed the bumpers"), unit="J"
        )
    if kind == "v":
        if of in [cart.name for cart in scene.carts]:
            return Shown(
                kind="v", of=of, label=said("velocity of {name} at the end", name=of), unit="m/s"
            )
        refuse("unknown-path", f"there is no cart “{of[:40]}”", f"show: v.{scene.carts[0].name}")
        return None
    if kind == "F":
        return _force(of, scene, refuse)
    refuse("not-a-choice", f"a map cannot show “{str(value)[:40]}”")
    return None


def _force(of: str, scene: Scene, refuse: Any) -> Shown | None:
    for k, contact in enumerate(scene.contacts):
        left, right = scene.names_at(k)
        if contact is None or of not in (f"{left}-{right}", f"{right}-{left}"):
            continue
        if contact.sudden:
            refuse(
                "not-for-this-law",
                f"{contact.law} has no duration, so its force has no greatest value",
                "show: v.A or warmed, or use law: bumper",
            )
            return None
        names = [body_name(name, scene.track) for name in (left, right)]
        label = said("greatest force between {first} and {last}", first=names[0], last=names[1])
        return Shown(kind="F", of=f"{left}-{right}", label=label, unit="N")
    pairs = ["-".join(scene.names_at(k)) for k, c in enumerate(scene.contacts) if c is not None]
    refuse("unknown-pair", f"“{of[:40]}” are not two neighbours", f"neighbours: {', '.join(pairs)}")
    return None


def _refuse_more(
    controls: tuple[Control, ...], over: tuple[Control, ...], problems: list[Problem]
) -> None:
    if len(controls) > MOST_CONTROLS:
        message = f"a map takes at most {MOST_CONTROLS} more sliders"
        problems.append(Problem(("controls",), "wrong-count", message, "remove the others"))
    for k, control in enumerate(controls):
        if control.set in [axis.set for axis in over]:
            message = f"{control.set} is an axis of the map already"
            problems.append(Problem(("controls", k, "set"), "twice", message, "remove this slider"))


def _values(axis: Control, points: int | None) -> tuple[float, ...]:
    """SI. Exact decimals, evenly spread; left to itself about 200 with a round step."""
    low, high, per = (Fraction(repr(number)) for number in (axis.low, axis.high, axis.per))
    count = _round_count((high - low) / per) if points is None else points
    return tuple(float(low + (high - low) * k / (count - 1)) for k in range(count))


def _round_count(span: Fraction) -> int:
    """About 200 points whose step, in the unit shown, is 1, 2, 2.5 or 5 times a power of ten."""
    power = math.floor(math.log10(span / USUAL))
    best = 0
    for digits in ("1", "2", "2.5", "5"):
        for exponent in (power, power + 1):
            steps = span / (Fraction(digits) * Fraction(10) ** exponent)
            if steps.denominator == 1 and abs(steps - USUAL) < abs(best - USUAL):
                best = int(steps)
    return best + 1 if USUAL * 3 // 4 <= best <= USUAL * 5 // 4 else USUAL
