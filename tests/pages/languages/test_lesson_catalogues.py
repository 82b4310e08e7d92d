"""The catalogues of our own lessons: up to date, whole, in their language, with all marks."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sim.pages.language import words
from sim.pages.translate.catalogues import Source, catalogues_in
from sim.pages.translate.po_file import read_words, updated
from sim.pages.translate.put_in import units_of
from sim.pages.translate.translation import part_of, translations_of
from sim.pages.translate.unit import changed_marks
from tests.pages.given.interface_words import SCRIPTS

ROOT = Path(__file__).parents[3]
FOLDER = ROOT / "worksheets"
SOURCES = list(catalogues_in(FOLDER))


def name(source: Source) -> str:
    return f"{source.language}-{source.path.stem}"


def test_ten_lessons_and_their_banks_are_there_in_three_languages() -> None:
    assert len(SOURCES) == 36
    assert all(source.path.is_file() for source in SOURCES)


@pytest.mark.parametrize("source", SOURCES, ids=name)
def test_every_text_is_translated_and_the_catalogue_is_up_to_date(source: Source) -> None:
    part = part_of(source, ROOT)
    assert [unit.text for unit in part.made.open] == [], "carts words, then translate"
    text = source.path.read_text(encoding="utf-8")
    units = units_of(source.path, text)
    made = updated(source.catalogue, "", units, source.language, "")
    assert made == source.catalogue.read_text(encoding="utf-8"), "carts words"


@pytest.mark.parametrize("source", SOURCES, ids=name)
def test_formulas_links_attributes_and_places_stay(source: Source) -> None:
    for text, said in read_words(source.catalogue, "").words.items():
        assert changed_marks(text, said) == ([], []), text
        for mark in ("**", "“", "m·Δv"):
            assert text.count(mark) == said.count(mark), (text, said)


@pytest.mark.parametrize("source", SOURCES, ids=name)
def test_a_translation_keeps_every_number_of_its_text(source: Source) -> None:
    """0.67 m/s is 0.67 m/s in every language; words for numbers may be digits there."""
    for text, said in read_words(source.catalogue, "").words.items():
        here, there = (re.findall(r"\d+(?:\.\d+)?", one) for one in (text, said))
        assert sorted(here) == sorted(there), (text, said)


@pytest.mark.parametrize("source", SOURCES, ids=name)
def test_a_translation_is_in_its_own_script_and_no_copy(source: Source) -> None:
    """But for what holds numbers and units only."""
    words_of = read_words(source.catalogue, "").words.items()
    said = {text: ours for text, ours in words_of if re.search("[A-Za-z]{3}", text)}
    script = re.compile(SCRIPTS[source.language])
    assert [text for text, ours in said.items() if text == ours and " " in text] == []
    assert [ours for ours in said.values() if not script.search(ours.lower())] == []


@pytest.mark.parametrize("source", SOURCES, ids=name)
def test_a_catalogue_of_ours_says_that_it_is_a_draft(source: Source) -> None:
    assert read_words(source.catalogue, "").draft


@pytest.mark.parametrize("language", ["ms", "ta", "zh-Hans"])
def test_lessons_name_what_readers_press_as_the_page_names_it(language: str) -> None:
    third = read_words(FOLDER / "words" / language / "newtons-third-law.po", "").words
    label = words(language)["My answers"]
    assert any(label in said for text, said in third.items() if "*My answers*" in text)
    first = read_words(FOLDER / "words" / language / "newtons-first-law.po", "").words
    (said,) = (said for text, said in first.items() if text.startswith("Press Play, then Start"))
    assert all(words(language)[button] in said for button in ("Play", "Start"))
    box = words(language)["The forces are hidden. Find those on both carts, and you see them all"]
    called = re.split("[.。]", box)[0]
    assert any(called in said for text, said in third.items() if "*The forces are hidden*" in text)
    buttons = {
        "momentum-and-restitution": ("Reset all values", "as a ledger"),
        "real-carts": ("Fit the model", "Compare with friction and tilt", "Follow"),
    }
    for lesson, named in buttons.items():
        said_of = read_words(FOLDER / "words" / language / f"{lesson}.po", "").words
        for button in named:
            (said,) = (said for text, said in said_of.items() if f"*{button}*" in text)
            assert f"*{words(language)[button]}*" in said


def test_the_forms_of_the_returns_draw_translated_items() -> None:
    made = list(translations_of(FOLDER / "return-week-8.md", FOLDER, ROOT))
    assert [one.source.language for one in made] == ["ms", "ta", "zh-Hans"]
    for one in made:
        (text,) = one.described(ROOT).texts.values()
        assert "A tug draws" not in text
