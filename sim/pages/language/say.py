"""A sentence in the language that is being written now."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType

from markupsafe import Markup, escape

# A form with fewer words of its own, “{first} and {last}”, is only a part of another: alone it
# would be found in what an author wrote.
ENOUGH = 2
_PLACE = re.compile(r"\{(\w+)\}")
_words: ContextVar[Mapping[str, str]] = ContextVar("carts-words", default=MappingProxyType({}))


def tr(sentence: str, **values: object) -> str:
    """The sentence with its values in the places {name}.

    It must stand in the call as text, or be `mark`ed elsewhere, so that it is found for the
    catalogues.
    """
    said = _words.get().get(sentence, sentence)
    return _PLACE.sub(lambda place: str(values.get(place[1], place[0])), said)


def tr_html(sentence: str, **values: object) -> Markup:
    """The same for templates: values that are no markup are escaped."""
    said = str(escape(_words.get().get(sentence, sentence)))
    return Markup(_PLACE.sub(lambda place: str(escape(values.get(place[1], place[0]))), said))


def heard(english: str) -> str:
    """A sentence that the numerics or a validator made, told in the language of the page.

    It is known by its form: the catalogue's sentence with the most text of its own that fits.
    What stands at the {names} is told the same way. Unknown sentences stay as they are.
    """
    words = _words.get()
    if english in words:
        return words[english]
    return _told_as(english, [form for form in _forms(tuple(words)) if form.words >= ENOUGH])


def _told_as(english: str, forms: Sequence[_Form]) -> str:
    words = _words.get()
    if english in words:
        return words[english]
    for form in forms:
        found = form.pattern.fullmatch(english)
        if found:
            parts = found.groupdict().items()
            told = {name: _told_as(part, _forms(tuple(words))) for name, part in parts}
            return tr(form.key, **told)
    return english


@dataclass(frozen=True, slots=True)
class _Form:
    key: str
    pattern: re.Pattern[str]
    words: int  # of its own


@cache
def _forms(keys: tuple[str, ...]) -> tuple[_Form, ...]:
    """Keys with places, those with most text of their own first."""
    with_places = [key for key in keys if _PLACE.search(key)]
    with_places.sort(key=lambda key: -len(_PLACE.sub("", key)))
    return tuple(_Form(key, form_of(key), len(_PLACE.sub("", key).split())) for key in with_places)


def form_of(key: str) -> re.Pattern[str]:
    """What a sentence looks like that fills the places of `key`."""
    parts, named = [], set()
    for k, piece in enumerate(_PLACE.split(key)):
        if k % 2 == 0:
            parts.append(re.escape(piece))
        elif piece in named:
            parts.append(f"(?P={piece})")  # the same again
        else:
            named.add(piece)
            parts.append(f"(?P<{piece}>.+?)")
    return re.compile("".join(parts), re.DOTALL)


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
