"""Readings of real carts in another language: no sentence of their block is English there."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.pages.language import speaking, words
from sim.pages.language.catalogue import own_words_script, words_script
from sim.pages.language.extract import sentences
from sim.scene.said import from_wire, in_words
from tests.measured.devices import Motion, motion_capture, phone, sensor_carts
from tests.measured.makers import as_text, film, truth
from tests.measured.refused_texts import REFUSED
from tests.pages.given.interface_words import BRACKETS, WORD, page_words, untold
from tests.web.figures.measured_site import BLOCKS, element

DATA = Path(__file__).parents[3] / "worksheets" / "data"
OWN = Motion(v=(0.5, -0.1), touch=1.0, until=2.0)
TEXTS = {
    "film": [as_text(film(truth()))],
    "lesson": [(DATA / "real-carts.txt").read_text("utf-8")],
    "forces": [(DATA / "real-carts-forces.csv").read_text("utf-8")],
    "cameras": [motion_capture(OWN, hidden=(3, 4))],
    "sensors": [sensor_carts(OWN)],
    "phones": [phone(OWN, 0), phone(OWN, 1, clock=0.2)],
}
ASKED: dict[str, dict[str, Any]] = {
    "read": {},
    "fit": {"own": True, "effect": "called", "masses": {"A": 0.5, "B": 1.0}},
    "segments": {},
}
SAID = {"read", "law_words", "added", "doubt", "reason", "hint", "sentences", "sentence", "line",
        "taken", "interval", "text", "scene", "name"}  # fmt: skip
"""Keys of an answer under which a reader finds sentences."""


def headers() -> Iterator[Any]:
    for do, more in ASKED.items():
        for texts in TEXTS.values():
            yield answer({"id": 1, "kind": "measured", "do": do, "texts": texts, **more})[0]
    for text, _, _ in REFUSED.values():
        yield answer({"id": 1, "kind": "measured", "do": "read", "texts": [text]})[0]


def said_in(value: Any, key: str = "") -> Iterator[Any]:
    """What stands under the keys of sentences, as the page gets it."""
    if isinstance(value, dict) and "code" not in value:
        for name, one in value.items():
            yield from said_in(one, name)
    elif isinstance(value, list) and not (value and isinstance(value[0], float)):
        for one in value:
            yield from said_in(one, key)
    elif key in SAID and value and not isinstance(value, (int, float)):
        yield value


def parts(sent: Any) -> Iterator[tuple[str, bool]]:
    """Templates, and values that are plain text."""
    if isinstance(sent, str):
        yield sent, False
    else:
        yield sent["code"], True
        for value in sent["values"].values():
            yield from parts(value)


@pytest.fixture(scope="module")
def sent() -> list[Any]:
    found = [one for header in headers() for one in said_in(json.loads(json.dumps(header)))]
    assert len(found) > 200
    return found


def test_all_that_is_said_of_readings_goes_to_the_page_as_templates(sent: list[Any]) -> None:
    known = sentences()
    for one in sent:
        for text, template in parts(one):
            if template and not text.startswith("# {remark}"):
                assert text in known
            elif not template:
                scene = text.startswith("title: ")  # a program reads it
                assert text in known or scene or len(WORD.findall(text)) < 2, one


def test_a_page_in_malay_tells_readings_in_malay(sent: list[Any]) -> None:
    given = page_words("ms", "measured")
    told = [in_words(from_wire(one), given) for one in sent if not isinstance(one, str)]
    english = re.compile(r"\b(the|is|are|of|with|by|these|what|which|they|not|left out)\b")
    assert [text for text in told if english.search(text.partition("carts:\n")[0])] == []
    assert "Troli melantun: troli bertemu, saling menolak dan berpisah." in told


def test_the_bench_itself_is_told_in_the_language_of_its_page() -> None:
    for body in BLOCKS.values():
        with speaking(BRACKETS):
            left = untold(element(body))
        assert left <= {"Our own carts"}, body  # what an author wrote


def test_only_pages_with_readings_carry_their_words() -> None:
    for language in ("ms", "ta", "zh-Hans"):
        key = '"The carts bounce: they come together, push each other and part.":'
        assert key in own_words_script("measured", language)
        assert key not in words_script(language)
        assert words(language)
