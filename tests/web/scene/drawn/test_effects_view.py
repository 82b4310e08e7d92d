"""How effects are drawn and told, each as its own folder says: `sim/effects/<kind>/view.js`."""

from __future__ import annotations

import re
from typing import Any

import pytest

from sim.pages.language import speaking
from sim.pages.language.extract import sentences
from sim.pages.widget import render
from tests import registry
from tests.web.runtime.boot_site import ROOT
from tests.web.scene.given.widget_site import MEETING, baked, in_node

SCENES: dict[str, dict[str, Any]] = {
    name: registry.plain(name) for name in registry.NAMES if "effects" in registry.plain(name)
}
# Every sentence told so that a test can see which were told: "on A by B" is "⟦on A by B⟧".
MARKED = {sentence: f"⟦{sentence}⟧" for sentence in sentences()}


def picture(fence: dict[str, Any]) -> str:
    """What a page shows of a scene, without the numbers that only its script reads."""
    return render(*baked({"id": "scene", **fence})).partition('<script type="application/json"')[0]


@pytest.mark.parametrize("name", ["push-a-train", "incline-friction-holds", "spring-pair"])
def test_a_prediction_hides_forces_and_their_numbers(name: str) -> None:
    """The set-up is drawn; how large a force is, and what comes of it, is not."""
    page = picture({**SCENES[name], "predict": {"text": "What happens?"}})
    (acting,) = re.findall(r'class="carts-acting">([^<]*)<', page)
    assert not re.search(r"μ = |\d N", acting)
    assert "carts-acts" not in page
    assert "begins" not in page


def test_hidden_forces_of_effects_are_not_in_the_picture() -> None:
    page = picture({**SCENES["balanced-push"], "forces": "hidden"})
    assert "carts-acts" not in page
    assert "carts-hand" in page
    assert "0.0981" not in page


def test_what_is_switched_off_is_not_drawn() -> None:
    effects = [{"friction": {"coefficient": 1, "active": False}}]
    page = picture({**SCENES["friction-stop"], "effects": effects})
    assert "carts-rough" not in page
    assert "carts-acts" not in page


def test_a_track_that_is_bent_between_two_carts_has_a_wedge_for_either_part() -> None:
    """They stood on each other, and each said that the whole track was tilted."""
    bent = [
        {"incline": {"angle": "2 deg", "carts": ["A"]}},
        {"incline": {"angle": "-3 deg", "carts": ["B"]}},
    ]
    page = picture({**MEETING, "effects": bent})
    words = re.findall(r'<text [^>]*y="([\d.]+)"[^>]*class="carts-tilt"[^>]*>([^<]*)<', page)
    wide = words[: len(words) // 2]
    assert [text.partition(":")[0] for _, text in wide] == ["A", "B"]
    assert len({y for y, _ in wide}) == 2


@pytest.mark.parametrize("name", SCENES)
def test_no_word_of_a_picture_is_left_in_english(name: str) -> None:
    """In a language that marks every sentence, nothing of two words stands outside the marks."""
    described, header, numbers = baked({"id": "scene", **SCENES[name], "title": "⟦⟧"})
    with speaking(MARKED):
        page = render(described, header, numbers).partition('<script type="application/json"')[0]
    texts = re.findall(r">([^<>]+)<", page)
    texts += re.findall(r'(?:aria-label|title|aria-valuetext)="([^"]*)"', page)
    for text in texts:
        plain = text
        while "⟦" in plain:
            plain, before = re.sub(r"⟦[^⟦⟧]*⟧", "", plain), plain
            assert plain != before, text
        assert not re.search(r"[A-Za-z]{3,} [A-Za-z]{2,}", plain), text


def test_every_kind_has_a_view_that_is_collected() -> None:
    listed = (ROOT / "sim/effects/views.js").read_text(encoding="utf-8")
    for folder in (ROOT / "sim/effects").iterdir():
        if folder.is_dir() and not folder.name.startswith("_"):
            assert re.search(rf'^  "?{folder.name}"?[,:]', listed, re.MULTILINE), "make bundle"


def drawn(kind: str, **words: str) -> Any:
    """What is said and drawn of an effect that Python tells so much about."""
    _, header, numbers = baked(MEETING)
    header["effects"] = [
        {"kind": kind, "index": 0, "active": True, "numbers": {"speed": 1.0}, "carts": ["A", "B"],
         "between": None, "by": None, **words}
    ]  # fmt: skip
    header["columns"] = [*header["columns"], ["E", kind, "A"]]
    return in_node(
        """const w = await import(view + "/effects-words.js");
        const f = await import(view + "/effects-forces.js");
        const t = await import(view + "/trajectory.js");
        const run = { header: data.header,
          trajectory: t.fromWire(data.header, Float64Array.from(data.numbers)) };
        try { give([w.actingSentences(data.header, true),
          f.forcesAt(run, 0).map((force) => f.labels(force)[0])]); }
        catch (error) { give(error.message); }""",
        {"header": header, "numbers": [*numbers, *[0.25] * header["rows"]]},
    )


def test_an_effect_without_a_view_is_a_force_with_the_name_that_python_tells() -> None:
    said, forces = drawn("tide", called="a tide", agent="the sea")
    assert said.startswith("In this model: a tide.")
    assert forces == ["on A by the sea: 0.250 N"]


def test_an_effect_that_nobody_describes_is_a_fault_and_not_another_effect() -> None:
    assert drawn("tide") == "nobody describes an effect of the kind “tide”"
