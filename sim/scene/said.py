"""A sentence for readers as a template and the values in it: so it can be told in any language.

    said("{cart} is at {place}", cart="A", place="0.40 m")

It is English text wherever text is wanted. Who speaks another language takes the template, which is
its key in the catalogues, and the values, which may be sentences themselves; no finished sentence
is ever taken apart. Templates stand in the call as text: that is how the catalogues find them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

PLACE = re.compile(r"\{(\w+)\}")


class Said(str):
    """The English text of `template` with its `values` at their places {name}."""

    template: str
    values: Mapping[str, str]

    def __new__(cls, template: str, values: Mapping[str, str]) -> Said:
        """Make the English text."""
        text = PLACE.sub(lambda place: values.get(place[1], place[0]), template)
        made = super().__new__(cls, text)
        made.template, made.values = template, values
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return Said, (self.template, dict(self.values))


def said(template: str, **values: str) -> Said:
    """The sentence; every value is text, or a sentence of its own."""
    return Said(template, values)


def template(text: str) -> str:
    """Says that a text is a template for readers, where `said` comes later."""
    return text


def listed(items: Sequence[str]) -> str:
    """A, B and C as “A and B and C”, in a way that another language can turn round."""
    if len(items) < 2:
        return "".join(items) if not items else items[0]
    return said("{first} and {last}", first=listed(items[:-1]), last=items[-1])


def listed_or(items: Sequence[str]) -> str:
    """A, B or C as “A or B or C”."""
    if len(items) < 2:
        return "".join(items) if not items else items[0]
    return said("{first} or {last}", first=listed_or(items[:-1]), last=items[-1])


def commas(items: Sequence[str]) -> str:
    """A, B, C; of thousands too, for it is halved and not told one in the other."""
    if len(items) < 2:
        return items[0] if items else ""
    middle = len(items) // 2
    return said("{first}, {then}", first=commas(items[:middle]), then=commas(items[middle:]))


def joined(*sentences: str) -> str:
    """Sentences one after the other, as one; empty ones are left out."""
    found = [sentence for sentence in sentences if sentence]
    if len(found) < 2:
        return found[0] if found else ""
    return said("{first} {then}", first=joined(*found[:-1]), then=found[-1])


def reason_of(error: Exception) -> str:
    """What an error says, as it was said: `str()` would make plain English of it."""
    told = error.args[0] if error.args else ""
    return told if isinstance(told, str) else str(error)


def in_words(text: str, words: Mapping[str, str]) -> str:
    """The sentence, or a word, in a language; `words`: what each English sentence is in it."""
    if not isinstance(text, Said):
        return words.get(text, text)
    values = {name: in_words(value, words) for name, value in text.values.items()}
    return str(Said(words.get(text.template, text.template), values))


def wire(text: str) -> str | dict[str, Any]:
    """What goes to the page: code (the template) and values, or plain text as it is."""
    if not isinstance(text, Said):
        return text
    values = {name: wire(value) for name, value in text.values.items()}
    return {"code": text.template, "values": values}


def from_wire(told: Any) -> str:
    """The sentence that `wire` has taken apart."""
    if not isinstance(told, Mapping):
        return str(told)
    return Said(told["code"], {name: from_wire(value) for name, value in told["values"].items()})
