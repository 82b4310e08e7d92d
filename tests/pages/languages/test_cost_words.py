"""What accuracy costs, in another language: no sentence of its block is English there."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from sim.bridge.protocol import answer
from sim.dynamics.cost import measure
from sim.pages.cost.block import USUAL_TITLE, CostBlock
from sim.pages.cost.render import MEASURED, WHEN, render_cost
from sim.pages.language import speaking, words
from sim.pages.language.catalogue import own_words_script, words_script
from sim.scene.said import from_wire
from tests import registry
from tests.pages.given.interface_words import BRACKETS, page_words, texts_in, untold

SCENE = "paper-two-carts"
BLOCK = CostBlock("costs", USUAL_TITLE, {SCENE: registry.plain(SCENE)}, {SCENE: "[…]"}, True)


def test_the_figure_is_told_in_the_language_of_its_page() -> None:
    with speaking(BRACKETS):
        assert {text.strip() for text in untold(render_cost(BLOCK))} == {"Verlet + Richardson"}


def test_a_malay_page_says_nothing_of_it_in_english() -> None:
    english = re.compile(r"\b(the|is|are|of|in|with|each|points?|map|run|steps?|error|exactly?)\b")
    with speaking(words("ms")):
        told = texts_in(render_cost(BLOCK))
    assert [text for text in told if english.search(text)] == []
    assert "Tenaga gerakan" in told


@pytest.mark.parametrize("file", sorted(MEASURED.glob("*.json")), ids=lambda file: file.stem)
def test_a_table_says_when_it_was_measured_as_a_template(file: Path) -> None:
    found = json.loads(file.read_text(encoding="utf-8"))
    assert ("measured" in found) == (file.stem != "breaks")  # counted on a map, and not timed
    if "measured" in found:
        assert found["measured"]["code"] == WHEN
        assert re.match(r"on \d+ \w+ 2\d{3} with CPython", from_wire(found["measured"]))


def test_a_method_that_cannot_follow_says_why_as_a_template(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A step of 3 s / 19 carries Yoshida's magnets through each other."""
    monkeypatch.setattr(measure, "LADDER", (("yoshida", (19, 61)),))
    request = {"id": 1, "kind": "cost", "scene": registry.plain("magnets-repel"), "row": 1}
    reason = answer(request)[0]["not_run"]["reason"]
    given = page_words("ms", "cost")
    assert reason["code"] in given
    assert reason["values"]["effect"] in given


def test_only_pages_with_the_figure_carry_its_words() -> None:
    for language in ("ms", "ta", "zh-Hans"):
        assert '"Error against time":' in own_words_script("cost", language)
        assert '"Error against time":' not in words_script(language)
