"""A `scene` fence: the scene, and how a lesson shows it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from sim.scene.fence.choices import choice, choices
from sim.scene.fence.controls import Control, read_controls
from sim.scene.fence.effect_controls import Switch, read_switches
from sim.scene.fence.predict import KINDS, Predict, kind_of, read_predict
from sim.scene.fence.presets import read_presets
from sim.scene.fields import SKINS
from sim.scene.model import Scene
from sim.scene.problem import Problem, SceneError
from sim.scene.quantity import SPEED, QuantityError, read_quantity
from sim.scene.read import SCENE_KEYS, collect_scene
from sim.scene.reading.effects import all_effects
from sim.scene.tables import mapping, unknown_keys

FENCE_KEYS = (
    *("id", "show", "with", "controls", "presets", "predict"),
    *("forces", "slow", "watch", "view", "boxes", "packages", "worlds"),
)
SHOWS = ("x", "v", "a", "F", "R", "p", "energy")
FORCE_GRAPHS = ("F", "R", "a")
FORCES = ("shown", "hidden", "none")
VIEWS = ("free-body", "lens", "bars")
TOOLS = ("ruler", "stopwatch")  # that a reader works
PACKAGES = ("numpy", "scipy")
WORLDS = "sim.worlds.describe"
ID = re.compile(r"[a-z][a-z0-9-]{0,63}", re.ASCII)


@dataclass(frozen=True, slots=True, kw_only=True)
class Fence:
    """A scene as a lesson shows it. `plain` are the scene's own keys as the author wrote them."""

    id: str
    scene: Scene
    plain: Mapping[str, Any]
    show: tuple[str, ...]
    opened: tuple[str, ...]  # in the fence “with”: views beside the graphs, and tools
    controls: tuple[Control, ...]
    switches: tuple[Switch, ...]  # among the controls: which effects a reader may turn on and off
    presets: Mapping[str, Mapping[str, Any]]  # changes to the scene, by the name on the button
    predict: Predict | None
    forces: str  # shown | hidden: until the reader has found them | none
    slow: str  # auto | never | stops
    watch: str  # first | free: whether a run is watched before it is known; "": as the page has it
    skins: Mapping[str, str]  # by the name of the cart: what it is drawn as, if not as a cart
    boxes: str  # mass | alike: what the size of a cart's box says
    view_speed: float  # m/s, of the camera; 0: at rest on the track
    packages: tuple[str, ...]
    worlds: tuple[Any, ...] = ()  # impossible ones, see `sim.worlds`

    @property
    def watched_first(self) -> bool:
        """Whether nothing of a run is shown before it has been played."""
        return self.watch == "first" or (not self.watch and self.predict is not None)


PREDICTED = "it belongs to “predict:”, and begins two spaces further right"


def read_fence(plain: object, *, named: bool = True) -> Fence:
    """The fence that `plain` describes; raises SceneError with every problem.

    A scene file is a fence that need not be `named`: it may have an id, or go without.
    """
    problems: list[Problem] = []
    table = mapping(plain, (), problems, "a scene is a table of keys, for example “carts:”")
    if table is None:
        raise SceneError(problems)
    further = dict.fromkeys(KINDS, PREDICTED) if "predict" in table else None
    unknown_keys(table, (*FENCE_KEYS, *SCENE_KEYS), (), problems, elsewhere=further)
    scene_part = {key: value for key, value in table.items() if key in SCENE_KEYS}
    scene = collect_scene(scene_part, problems)
    identity = _identity(table, problems, named=named)
    show = choices("show", table, ("x", "v", "F"), SHOWS, problems)
    opened = choices("with", table, (), (*VIEWS, *TOOLS), problems)
    packages = choices("packages", table, (), PACKAGES, problems)
    forces = _forces(table, show, problems)
    slow = choice("slow", table, ("auto", "never", "stops"), problems)
    watch = choice("watch", table, ("first", "free"), problems) if "watch" in table else ""
    boxes = choice("boxes", table, ("mass", "alike"), problems)
    speed = _view(table.get("view"), problems)
    controls: tuple[Control, ...] = ()
    switches: tuple[Switch, ...] = ()
    presets: dict[str, dict[str, Any]] = {}
    if scene is not None:
        effects = all_effects(table, scene)
        controls = read_controls(table.get("controls", []), scene, problems, effects)
        switches = read_switches(table.get("controls", []), effects, problems)
        presets = read_presets(table.get("presets", {}), scene_part, problems)
    predict = _predict(table, scene, problems)
    worlds: tuple[Any, ...] = ()
    if "worlds" in table and scene is not None:  # else nothing of them is even imported
        worlds = import_module(WORLDS).read_worlds(table["worlds"], scene, problems)
    if problems or scene is None:
        raise SceneError(problems)
    return Fence(
        id=identity,
        scene=scene,
        plain=scene_part,
        show=show,
        opened=opened,
        controls=controls,
        switches=switches,
        presets=presets,
        predict=predict,
        forces=forces,
        slow=slow,
        watch=watch,
        skins=_skins(scene_part["carts"]),
        boxes=boxes,
        view_speed=speed,
        packages=packages,
        worlds=worlds,
    )


def _skins(carts: Mapping[str, Mapping[str, Any]]) -> dict[str, str]:
    """What carts are drawn as; of a scene that has been read."""
    skins = {name: cart.get("skin", SKINS[0]) for name, cart in carts.items()}
    return {name: skin for name, skin in skins.items() if skin != SKINS[0]}


def _identity(table: Mapping[str, Any], problems: list[Problem], *, named: bool) -> str:
    """The id; one that is missing or no id is a problem."""
    identity = table.get("id", None if named else "file")
    if isinstance(identity, str) and ID.fullmatch(identity):
        return identity
    given = "id" in table
    message = f"“{str(identity)[:40]}” cannot be an id" if given else "id is missing"
    hint = "small letters, digits and hyphens, one of its kind in the whole site: "
    problems.append(
        Problem(
            ("id",) if given else (),
            "bad-name" if given else "missing",
            message,
            f"{hint}id: light-meets-heavy",
        )
    )
    return str(identity)


def _predict(
    table: Mapping[str, Any], scene: Scene | None, problems: list[Problem]
) -> Predict | None:
    """The prediction, if there is one; without a scene only its kind can be judged."""
    too_far_left = any(kind in table for kind in KINDS)
    if "predict" not in table or too_far_left:
        return None
    if scene is None:
        kind_of(table["predict"], problems)
        return None
    return read_predict(table["predict"], scene, problems)


def _forces(table: Mapping[str, Any], show: tuple[str, ...], problems: list[Problem]) -> str:
    """How forces are shown; a graph that would tell them is an error, if it was asked for."""
    forces = choice("forces", table, FORCES, problems)
    if forces not in FORCES[1:]:
        return forces
    telling = [quantity for quantity in show if quantity in FORCE_GRAPHS]
    if "show" in table and telling:
        problems.append(
            Problem(
                ("show",),
                "hidden-forces",
                f"the forces are not shown, so there can be no graph of {' or '.join(telling)}",
                f"leave {' and '.join(telling)} out of show, or write forces: shown",
            )
        )
    return forces


def _view(value: object, problems: list[Problem]) -> float:
    if value is None or value == "track":
        return 0.0
    hint = "view: moving 0.3 m/s"
    if isinstance(value, str) and value.startswith("moving "):
        try:
            return float(read_quantity(value[len("moving ") :], SPEED))
        except QuantityError as error:
            problems.append(Problem(("view",), error.code, error.message, hint))
            return 0.0
    problems.append(
        Problem(("view",), "not-a-choice", "view is “track” or “moving” with a speed", hint)
    )
    return 0.0
