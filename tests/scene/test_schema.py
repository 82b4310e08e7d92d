"""The schema of a scene knows good scenes from bad ones, as far as single keys go."""

from __future__ import annotations

import json
from typing import Any

import pytest

from sim.pages.question.published import published
from sim.scene import SceneError, read_scene
from sim.scene.effects import kinds
from sim.scene.laws import laws
from sim.scene.schema import scene_schema
from tests import registry
from tests.lesson.json_schema import faults

CART = {"mass": 1, "position": "0.4 m"}
GOOD = {"carts": {"A": CART}}


@pytest.mark.parametrize("name", registry.NAMES)
def test_every_scene_of_the_registry_fits(name: str) -> None:
    assert list(faults(registry.plain(name), scene_schema())) == []


BAD: dict[str, dict[str, Any]] = {
    "no carts": {"title": "nothing"},
    "a cart without a mass": {"carts": {"A": {"position": 0}}},
    "a mass of 0": {"carts": {"A": CART | {"mass": 0}}},
    "a mass that is no number": {"carts": {"A": CART | {"mass": "heavy"}}},
    "a misspelt key of a cart": {"carts": {"A": CART | {"velocty": 1}}},
    "a cart called 1": {"carts": {"1": CART}},
    "a misspelt key": GOOD | {"untill": 3},
    "an unknown law": GOOD | {"contact": {"law": "rubber"}},
    "a restitution above 1": GOOD | {"contact": {"restitution": 1.5}},
    "a bad pair": GOOD | {"contact": {"pairs": {"A-right": {"restitution": 2}}}},
    "a side that is ajar": GOOD | {"track": {"left": "ajar"}},
    "an end of glass": GOOD | {"track": {"length": 2, "right": "wall", "right_is": "glass"}},
    "an unknown effect": GOOD | {"effects": [{"gale": {"speed": 3}}]},
    "an effect without its number": GOOD | {"effects": [{"friction": {}}]},
    "an effect without its cart": GOOD | {"effects": [{"push": {"force": 1}}]},
    "drag without either number": GOOD | {"effects": [{"drag": {}}]},
    "an angle too steep": GOOD | {"effects": [{"incline": {"angle": 2}}]},
}


@pytest.mark.parametrize("what", BAD)
def test_what_a_scene_is_refused_for_the_schema_refuses_too(what: str) -> None:
    assert list(faults(BAD[what], scene_schema())) != []
    with pytest.raises(SceneError):
        read_scene(BAD[what])


def test_it_names_every_law_and_every_number_of_every_effect() -> None:
    made = scene_schema()["properties"]
    assert made["contact"]["properties"]["law"]["anyOf"][0]["enum"] == list(laws())
    listed = [entry["properties"] for entry in made["effects"]["items"]["anyOf"]]
    assert [next(iter(entry)) for entry in listed] == list(kinds())
    for entry, kind in zip(listed, kinds().values(), strict=True):
        assert {field.key for field in kind.fields} <= set(entry[kind.name]["properties"])


def test_editors_find_it_where_it_is() -> None:
    """In this project, for its scene files."""
    settings = json.loads((registry.ROOT / ".vscode" / "settings.json").read_text())
    (schema,) = [path for path in settings["yaml.schemas"] if "scene" in path]
    assert schema in published()
    globs = settings["yaml.schemas"][schema]
    assert all(list(registry.ROOT.glob(glob)) for glob in globs if "scenes" in glob)
