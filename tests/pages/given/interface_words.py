"""The words of the interface as a test can see them, and the sentences that runs send."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

from sim.bridge.protocol import answer
from sim.pages.language.catalogue import own_words_script, words_script
from sim.pages.language.extract import sentences
from sim.scene.said import Said
from tests import registry

# Each sentence told in a language that a test can see: [its English text].
BRACKETS = {sentence: f"[{sentence}]" for sentence in sentences()}
SCRIPTS = {"zh-Hans": r"[\u4e00-\u9fff]", "ta": r"[\u0b80-\u0bff]", "ms": r"[a-z]"}


WORD = re.compile(r"[a-z]{3,}")
"""Two of them are a sentence; one may be a unit, or a name in a file."""


def page_words(language: str, element: str) -> dict[str, str]:
    """The words that a page with such an element gets."""
    given = json.loads(words_script(language).partition("=")[2].removesuffix(";\n"))
    own = own_words_script(element, language).partition(",")[2].removesuffix(");\n")
    found: dict[str, str] = given | json.loads(own)
    return found


def texts_in(html: str) -> list[str]:
    """What a reader of an element sees or hears."""
    made = re.sub(r"<script.*?</script>", "", html, flags=re.DOTALL)
    heard = re.findall(r'aria-(?:label|valuetext)="([^"]*)"', made)
    return [*re.findall(r">([^<]+)<", made), *heard]


def untold(html: str) -> set[str]:
    """Sentences of an element, told in BRACKETS, that are English: nobody has told them."""
    return {text for text in texts_in(html) if len(WORD.findall(_told_apart(text))) > 1}


def _told_apart(text: str) -> str:
    """The text without names of files and without all that was told: [one [in another]]."""
    text, left = re.sub(r"\S+\.(txt|csv)\b", "", text), ""
    while text != left:
        left, text = text, re.sub(r"\[[^\[\]]*\]", "", text)
    return text


def rebuilt(sent: Any) -> str:
    """What came over the wire as the inner layers had it."""
    if isinstance(sent, str):
        return sent
    values = {name: rebuilt(value) for name, value in sent["values"].items()}
    return Said(sent["code"], values, sent.get("one", ""))


def sent_of_runs() -> Iterator[Any]:
    for name in registry.NAMES:
        header, _ = answer({"id": 1, "kind": "run", "scene": registry.plain(name), "samples": 1})
        yield from (phase["why"] for phase in header["plan"])
        yield from (warning["message"] for warning in header["warnings"])
