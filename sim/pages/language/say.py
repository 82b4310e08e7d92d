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


def spoken() -> Mapping[str, str]:
    """The words that sentences are told in now; empty: English."""
    return _words.get()


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
    What stands at the {names} is told the same way, and may be a list: “A with B, a push”. Unknown
    sentences stay as they are.
    """
    words = _words.get()
    return words.get(english) or _filled(english, _large(tuple(words))) or english


def _part(english: str) -> str:
    """What stands at a name: a sentence of its own, a list, or a small form."""
    words = _words.get()
    said = words.get(english) or _filled(english, _large(tuple(words)))
    if said:
        return said
    if ", " in english:
        return ", ".join(map(_part, english.split(", ")))
    return _filled(english, _forms(tuple(words))) or english


def _filled(english: str, forms: Sequence[_Form]) -> str:
    for form in forms:
        if found := form.pattern.fullmatch(english):
            return tr(form.key, **{name: _part(said) for name, said in found.groupdict().items()})
    return ""


@dataclass(frozen=True, slots=True)
class _Form:
    key: str
    pattern: re.Pattern[str]
    own: str  # text

    @property
    def words(self) -> int:
        return len(self.own.split())


@cache
def _forms(keys: tuple[str, ...]) -> tuple[_Form, ...]:
    """Keys with places, those with most text of their own first."""
    made = [_Form(key, _form_of(key), _PLACE.sub("", key)) for key in keys if _PLACE.search(key)]
    return tuple(sorted(made, key=lambda form: (-len(form.own), form.key)))


@cache
def _large(keys: tuple[str, ...]) -> tuple[_Form, ...]:
    return tuple(form for form in _forms(keys) if form.words >= ENOUGH)


def _form_of(key: str) -> re.Pattern[str]:
    """What a sentence looks like that fills the places of `key`; {a} holds a single word."""
    parts, named = [], set()
    for k, piece in enumerate(_PLACE.split(key)):
        if k % 2 == 0:
            parts.append(re.escape(piece))
        elif piece in named:
            parts.append(f"(?P={piece})")  # the same again
        else:
            named.add(piece)
            filling = r"[^\s,]+" if len(piece) == 1 else ".+?"
            parts.append(f"(?P<{piece}>{filling})")
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
