"""A map in another language: no sentence of its block, or of what Python answers, is English."""

from __future__ import annotations

import re
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.pages.language import speaking
from sim.pages.language.catalogue import own_words_script, words_script
from sim.pages.language.extract import sentences
from sim.pages.map.bake import MapRun, bake_map
from sim.pages.map.render import render_map
from sim.scene.fence.map import read_map
from sim.scene.said import from_wire, in_words
from tests import registry
from tests.pages.given.interface_words import BRACKETS, page_words, texts_in, untold

WALLS = {"length": "2.4 m", "left": "wall", "right": "wall"}
MASS = {"set": "A.mass", "from": "0.5 kg", "to": "5 kg"}
BOUNCE = {"set": "contact.restitution", "from": 0, "to": 1}
SLOWER = {"set": "A.velocity", "from": "0.1 m/s", "to": "3 m/s", "step": "0.1 m/s"}
PLAIN = registry.plain("light-meets-heavy")
USUAL = {"id": "map", "title": None, "over": [MASS, BOUNCE], "show": "v.A", "points": 5}
RUBBED = {"effects": [{"friction": {"coefficient": 0.1}}]}
MAPS: dict[str, dict[str, Any]] = {
    "velocity": PLAIN | USUAL,
    "curve": PLAIN | USUAL | {"over": [BOUNCE], "show": "warmed"},
    "force": PLAIN | USUAL | {"show": "F.A-B", "of": "above", "controls": [SLOWER]},
    "wall": PLAIN | USUAL | {"show": "F.B-right", "track": WALLS},
    "runs": PLAIN | USUAL | {"track": WALLS, "until": "20 s", "points": 50},
    "effects": PLAIN | USUAL | RUBBED,
    "series": registry.plain("hertz-pair") | USUAL | {"over": [MASS], "points": 2},
}


def element(plain: dict[str, Any]) -> str:
    described = read_map(plain)
    run = bake_map(described, plain)
    assert isinstance(run, MapRun)
    return render_map(described, plain, run)


@pytest.mark.parametrize("name", MAPS)
def test_a_map_is_told_in_the_language_of_its_page(name: str) -> None:
    with speaking(BRACKETS):
        assert untold(element(MAPS[name])) == set()


def test_a_malay_page_says_nothing_of_a_map_in_english() -> None:
    english = re.compile(r"\b(the|is|are|of|in|with|each|points?|map|run|no|force|from|slider)\b")
    with speaking(page_words("ms", "map")):
        for plain in MAPS.values():
            told = texts_in(element(plain))
            assert [text for text in told if english.search(text)] == []
            assert "Halaju A pada akhir" in told or plain["show"] != "v.A"


@pytest.mark.parametrize("name", MAPS)
def test_how_a_map_was_computed_goes_to_the_page_as_templates(name: str) -> None:
    why = answer({"id": 1, "kind": "map", "map": MAPS[name]})[0]["why"]
    parts = [why] if why["code"] != "{first} {then}" else list(why["values"].values())
    assert {part["code"] for part in parts} <= set(sentences())
    told = in_words(from_wire(why), page_words("ms", "map"))
    assert "titik" in told and "points" not in told


def test_only_pages_with_a_map_carry_its_words() -> None:
    for language in ("ms", "ta", "zh-Hans"):
        assert '"Open the map":' in own_words_script("map", language)
        assert '"Open the map":' not in words_script(language)
        assert '"Play":' not in own_words_script("map", language)
