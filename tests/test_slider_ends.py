"""Wherever a slider of a lesson stands, something meets before the run ends."""

from __future__ import annotations

import re
from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
import yaml

from sim.bridge.protocol import answer
from tests import registry

ROOT = Path(__file__).parents[1]
PAGES = ("docs/**/*.md", "worksheets/*.md", "sim/effects/*/page.md")
BLOCK = re.compile(r"^```(?:scene|map)[^\n]*\n(.*?)^```", re.M | re.S)
SCENE = ("carts", "track", "contact", "effects", "gravity", "start", "until")
MEETS = ("contact", "peak", "release")
NEVER = {
    ("gallery-equal-swap", "B.velocity", "0.6 m/s"),  # both are equally fast
    ("sandbox-eight", "A.velocity", "0 m/s"),  # at rest
}


def fences() -> list[dict[str, Any]]:
    """Every scene and map of the site."""
    pages = (page for place in PAGES for page in sorted(ROOT.glob(place)))
    texts = (page.read_text(encoding="utf-8") for page in pages)
    blocks = (block for text in texts for block in BLOCK.findall(text))
    return [yaml.safe_load(block) for block in blocks]


def offered() -> list[Any]:
    """Scene, its id, and one end of a slider of a cart or a contact."""
    found = []
    for fence in fences():
        name = Path(fence.get("file", "")).stem
        whole = {**(registry.plain(name) if name in registry.NAMES else {}), **fence}
        if "carts" not in whole:
            continue
        plain = {key: whole[key] for key in SCENE if key in whole}
        for slider in [*whole.get("controls", []), *whole.get("over", [])]:
            owner = str(slider.get("set", "")).partition(".")[0]
            if "from" not in slider or owner not in {*plain["carts"], "contact"}:
                continue
            for end in ("from", "to"):
                case = (str(whole.get("id")), slider["set"], str(slider[end]))
                found.append(pytest.param(plain, *case, id=" ".join(case)))
    return found


def meets(plain: dict[str, Any]) -> bool:
    """Whether something meets in a run, or the page says why there is none."""
    header, _ = answer({"id": 1, "kind": "run", "scene": plain})
    return not header["ok"] or any(event["kind"] in MEETS for event in header["events"])


@pytest.mark.parametrize(("plain", "name", "target", "value"), offered())
def test_at_either_end_of_a_slider_something_meets_where_it_does_in_the_scene(
    plain: dict[str, Any], name: str, target: str, value: str
) -> None:
    """On the home page, at 0.1 m/s, the run was over before A had come half the way."""
    owner, key = target.split(".")
    moved = deepcopy(plain)
    place = moved["carts"][owner] if owner in moved["carts"] else moved.setdefault("contact", {})
    place[key] = value
    assert meets(moved) or not meets(plain) or (name, target, value) in NEVER


def test_in_a_row_of_three_the_middle_one_meets_the_last_however_heavy_it_is() -> None:
    """With A of 1 kg and B of 8 kg the run ended before B came to C, and the map said 0."""
    (fence,) = [fence for fence in fences() if fence.get("id") == "map-middle-scene"]
    plain = {key: fence[key] for key in SCENE if key in fence}
    plain["carts"]["A"]["mass"], plain["carts"]["B"]["mass"] = "1 kg", "8 kg"
    header, _ = answer({"id": 1, "kind": "run", "scene": plain})
    assert ["B", "C"] in [event["bodies"] for event in header["events"]]
