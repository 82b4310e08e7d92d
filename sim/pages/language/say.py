"""A sentence in the language that is being written now."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from types import MappingProxyType

from markupsafe import Markup, escape

from sim.scene.said import PLACE, counted, in_words

_words: ContextVar[Mapping[str, str]] = ContextVar("carts-words", default=MappingProxyType({}))


def spoken() -> Mapping[str, str]:
    """The words that sentences are told in now; empty: English."""
    return _words.get()


def tr(sentence: str, **values: object) -> str:
    """The sentence with its values in the places {name}.

    It must stand in the call as text, or be `mark`ed elsewhere, so that it is found for the
    catalogues.
    """
    said = _words.get().get(sentence, sentence)
    return PLACE.sub(lambda place: str(values.get(place[1], place[0])), said)


def tr_counted(one: str, more: str, *, n: int, **values: object) -> str:
    """The sentence for `n` of something, as `counted` of sim.scene.said."""
    texts = {name: str(value) for name, value in values.items()}
    return in_words(counted(one, more, n=n, **texts), _words.get())


def tr_html(sentence: str, **values: object) -> Markup:
    """The same for templates: values that are no markup are escaped."""
    said = str(escape(_words.get().get(sentence, sentence)))
    return Markup(PLACE.sub(lambda place: str(escape(values.get(place[1], place[0]))), said))


def told(text: str) -> str:
    """A sentence of the inner layers (sim.scene.said), or a word of theirs, in this language."""
    return in_words(text, _words.get())


def told_if_ours(text: str, ours: str) -> str:
    """A text of ours in this language; another, which an author wrote, as it stands."""
    return told(text) if text == ours else text


def mark(sentence: str) -> str:
    """Says that a sentence is for the catalogues; it is translated later, where it is told."""
    return sentence


@contextmanager
def speaking(words: Mapping[str, str]) -> Iterator[None]:
    """Inside, sentences are told in these words; empty: in English."""
    before = _words.set(words)
    try:
        yield
    finally:
        _words.reset(before)
