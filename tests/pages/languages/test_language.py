"""Interface words: every catalogue is complete, and every sentence that a reader sees is in it."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sim.bridge.protocol import answer
from sim.pages.language import ENGLISH, LANGUAGES, of_page, speaking, told, tr, words
from sim.pages.language.catalogue import (
    FOLDER,
    OWN,
    UnknownLanguageError,
    own_words_script,
    read,
    words_script,
)
from sim.pages.language.extract import ROOT, SOURCES, counted_sentences, names_in, sentences
from sim.pages.language.plurals import forms_of, key_of
from sim.scene.effects import kinds
from sim.scene.said import RULE, listed, said
from tests import registry
from tests.pages.given.interface_words import BRACKETS, SCRIPTS, sent_of_runs

OTHERS = sorted(set(LANGUAGES) - {ENGLISH})
# Values that do not work, for sliders and for links.
WRONG = [0, -1, "abc", "5 kg", "1 furlong", "1e999", "nan", "2,5 kg", True]


def catalogue(language: str) -> dict[str, tuple[str, ...]]:
    """Of every sentence what is said in a language, in all its forms."""
    found = [entry for entry in read(language) if entry.id and not entry.fuzzy]
    return {key_of(entry.id): forms_of(entry.string) for entry in found}


@pytest.mark.parametrize("language", OTHERS)
def test_every_sentence_is_translated(language: str) -> None:
    said = catalogue(language)
    left = [key for key in sentences() if not all(said.get(key, [""]))]
    assert left == [], "run make words, translate"
    assert sorted(set(said) - set(sentences())) == [], "nobody says these: run make words"


@pytest.mark.parametrize("language", OTHERS)
def test_a_translation_keeps_the_places_of_its_sentence(language: str) -> None:
    """In all its forms; how many there are may be left out of one of them."""
    counts = counted_sentences()
    for sentence, forms in catalogue(language).items():
        for ours in forms:
            left_out = {"n"} if sentence in counts else set()
            assert names_in(ours) | left_out == names_in(sentence) | left_out, sentence
            assert ours[:1].isspace() == sentence[:1].isspace(), sentence
            assert ours[-1:].isspace() == sentence[-1:].isspace(), sentence


@pytest.mark.parametrize("language", OTHERS)
def test_a_translation_is_in_its_own_script(language: str) -> None:
    """A sentence that was copied over is no translation; names, symbols and units may stay."""
    script = re.compile(SCRIPTS[language])
    plain = {key: re.sub(r"\{\w+\}", "", key) for key in sentences()}
    same = [key for key, said in catalogue(language).items() if key in said]
    assert [key for key in same if len(re.findall(r"[a-z]{3,}", plain[key])) > 1] == []
    texts = [re.sub(r"\{\w+\}", "", one) for said in catalogue(language).values() for one in said]
    assert [one for one in texts if re.search(r"[^\W\d_]{4}", one) and not script.search(one)] == []


def test_chinese_sentences_have_chinese_marks() -> None:
    """Wide ones beside a Chinese character: a narrow comma has no room behind it."""
    sign = r"[\u4e00-\u9fff]"
    narrow = re.compile(rf"{sign}[,?;!:]|[,?;!:] ?{sign}")
    forms = [form for forms in catalogue("zh-Hans").values() for form in forms]
    assert [form for form in forms if narrow.search(form)] == []


def test_only_text_that_stands_in_the_call_is_translated() -> None:
    """What is put together first cannot be found for the catalogues."""
    for folder, pattern, _, functions in SOURCES:
        for path in sorted((ROOT / folder).rglob(pattern)):
            if "language" not in path.parts and path.suffix == ".py":
                if "mark" in functions:
                    assert_marked_in_place(path)
            elif "language" not in path.parts and path.name != "language.js":
                assert_translated_in_place(path)


def assert_marked_in_place(path: Path) -> None:
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        name = node.func.id if isinstance(node, ast.Call) and hasattr(node.func, "id") else ""
        if name == "mark":
            assert isinstance(node.args[0], ast.Constant), f"{path.name}:{node.lineno}"


def assert_translated_in_place(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    for call in re.finditer(r"(?<![\w.])tr\(\s*(\S)", text):
        assert call[1] in "\"'", f"{path.name}: {text[call.start() : call.start() + 60]}"
    if path.suffix == ".js":
        for key in translated_in(path):
            assert key in BRACKETS, "not found where it stands: a line more"


def translated_in(script: Path) -> list[str]:
    """Every text that a script hands to `tr`; of `counted` the form for more."""
    text, quoted = script.read_text(encoding="utf-8"), r'("(?:[^"\\]|\\.)*")'
    calls = re.findall(rf"(?<![\w.])tr\(\s*{quoted}", text)
    calls += re.findall(rf"(?<![\w.])counted\(\s*{quoted[1:-1]},\s*{quoted}", text)
    return [json.loads(found) for found in calls]


@pytest.mark.parametrize("language", OTHERS)
def test_what_a_script_says_is_among_the_words_that_its_page_gets(language: str) -> None:
    given = words_script(language) + "".join(own_words_script(one, language) for one in OWN)
    for path in sorted([*(ROOT / "sim/web/src").rglob("*.js"), *(ROOT / "sim/view").rglob("*.js")]):
        for text in translated_in(path):
            key = json.dumps(text, ensure_ascii=False)
            assert f"{key}:" in given, f"{path.name}: put {key} on a line of its own"


def codes(sent: Any) -> Iterator[str]:
    """The templates of a sentence and of all that stands in it."""
    if not isinstance(sent, str):
        yield sent["code"]
        for value in sent["values"].values():
            yield from codes(value)


def test_what_is_said_of_a_run_goes_to_the_page_as_templates_of_the_catalogues() -> None:
    sent = list(sent_of_runs())
    assert [one for one in sent if isinstance(one, str)] == []
    assert {code for one in sent for code in codes(one)} - set(sentences()) == set()


# Scenes that have each kind of number that a slider can set.
SET = ("off-the-wall", "release-and-friction", "spring-and-push", "drag-quadratic", "hertz-pair")


@pytest.mark.parametrize("name", [*SET, "magnets-repel", "incline-friction-holds"])
def test_what_is_said_of_a_wrong_value_goes_to_the_page_as_templates(name: str) -> None:
    plain = registry.plain(name)
    targets = [f"{cart}.{key}" for cart in plain["carts"] for key in ("mass", "position")]
    targets += ["contact.restitution", "contact.stiffness", "until", "track.length"]
    for effect in plain.get("effects") or ():
        kind, table = next(iter(effect.items()))
        targets += [f"{kind}.{key}" for key in table if key not in ("between", "cart", "carts")]
    sent = []
    for target in targets:
        for value in WRONG:
            request = {"id": 1, "kind": "run", "scene": plain, "set": {target: value}}
            header, _ = answer({**request, "samples": 1})
            for problem in header.get("problems", ()):
                sent += [problem["message"], problem["hint"]]
    assert sent, "every value fits: this test tests nothing"
    assert {one for one in sent if isinstance(one, str) and one} == set()
    assert {code for one in sent for code in codes(one)} - set(sentences()) == set()


def test_every_slider_has_a_label_that_the_catalogues_know() -> None:
    named = {field.label_of(number) for field in kinds().values() for number in field.fields}
    assert {str(label) for label in named if label not in BRACKETS} == set()


def test_what_an_author_wrote_stays_as_it_is() -> None:
    for text in ("Do A and B stick?", "Heavy and light", "push it", "mass and weight: why?"):
        with speaking(BRACKETS):
            assert told(text) == text


def test_a_sentence_is_turned_round_with_all_that_stands_in_it() -> None:
    chinese = {
        "{pairs} in contact": "<{pairs}>",
        "{first} and {last}": "{last}+{first}",
        "{a} with {b}": "{a}{b}",
    }
    pairs = listed([said("{a} with {b}", a="A", b="B"), said("{a} with {b}", a="B", b="C")])
    sentence = said("{pairs} in contact", pairs=pairs)
    assert sentence == "A with B and B with C in contact"
    with speaking(chinese):
        assert told(sentence) == "<BC+AB>"


def test_a_value_is_put_in_its_place_and_never_read_again() -> None:
    with speaking({"{a} and {b}": "{b}, {a}"}):
        assert tr("{a} and {b}", a="{b}", b="x") == "x, {b}"


@pytest.mark.parametrize(
    ("stated", "file", "theme", "language"),
    [
        (None, "worksheets/a.md", "en", "en"),
        (None, "worksheets/a.md", "zh-CN", "zh-Hans"),
        (None, "worksheets/a.md", "de", "en"),
        (None, "worksheets/ta/a.md", "en", "ta"),
        ("ms", "worksheets/ta/a.md", "en", "ms"),
        ("ms-SG", "a.md", "en", "ms"),
        (None, "ms.md", "en", "en"),
    ],
)
def test_a_page_speaks_as_it_says_or_as_its_folder_or_as_the_site(
    stated: str | None, file: str, theme: str, language: str
) -> None:
    assert of_page(stated, file, theme) == language


def test_an_unknown_language_is_named_with_those_there_are() -> None:
    with pytest.raises(UnknownLanguageError, match="“klingon”: there are en, ms, ta, zh-Hans"):
        of_page("klingon", "a.md", "en")


@pytest.mark.parametrize("language", OTHERS)
def test_no_catalogue_says_what_a_page_does_not(language: str) -> None:
    assert Path(FOLDER / f"{language}.po").exists()
    assert words(language).keys() <= {*sentences(), RULE}
