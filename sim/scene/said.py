"""A sentence for readers as a template and the values in it: so it can be told in any language.

    said("{cart} is at {place}", cart="A", place="0.40 m")

It is English text wherever text is wanted. Who speaks another language takes the template, which is
its key in the catalogues, and the values, which may be sentences themselves; no finished sentence
is ever taken apart. Templates stand in the call as text: that is how the catalogues find them.

    counted("1 run", "{n} runs", n=3)

English has a form for one and a form for more; other languages have one, three or six of them. A
catalogue gives all forms of its language under the form for more, and under a key that nobody says
which of them each number takes: `FORMS`, `RULE`, `form_of`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

PLACE = re.compile(r"\{(\w+)\}")
FORMS = "\0"
"""Stands between the forms of a counted sentence in a catalogue, as in gettext's own files."""
RULE = "\0"
"""The key in a catalogue of the rule of its language: for each number from 0 to 199 the digit of
its form. Rules of languages look at a number below a hundred, and else at its last two digits."""


class Said(str):
    """The English text of `template` with its `values` at their places {name}. A sentence that
    counts `n` of something has another text for `one`."""

    template: str
    values: Mapping[str, str]
    one: str

    def __new__(cls, template: str, values: Mapping[str, str], one: str = "") -> Said:
        """Make the English text."""
        made = super().__new__(cls, _filled(_english(template, values, one), values))
        made.template, made.values, made.one = template, values, one
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return Said, (self.template, dict(self.values), self.one)


def _filled(template: str, values: Mapping[str, str]) -> str:
    return PLACE.sub(lambda place: values.get(place[1], place[0]), template)


def _english(template: str, values: Mapping[str, str], one: str) -> str:
    return one if one and _count(values) == 1 else template


def _count(values: Mapping[str, str]) -> int:
    return int(values["n"].replace(",", ""))


def said(template: str, **values: str) -> Said:
    """The sentence; every value is text, or a sentence of its own."""
    return Said(template, values)


def counted(one: str, more: str, *, n: int, **values: str) -> Said:
    """The sentence for `n` of something: the template for one, and the one for any other number."""
    return Said(more, {"n": f"{n:,}", **values}, one)


def form_of(rule: str, n: int) -> int:
    """The number of the form that `n` takes, by the rule of a language; without a rule English."""
    if not rule:
        return 0 if n == 1 else 1
    return int(rule[n if n < len(rule) else 100 + n % 100])


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


def capital(text: str) -> str:
    """The text with a capital in front, as a sentence or a title begins."""
    return text[:1].upper() + text[1:]


def reason_of(error: Exception) -> str:
    """What an error says, as it was said: `str()` would make plain English of it."""
    told = error.args[0] if error.args else ""
    return told if isinstance(told, str) else str(error)


def in_words(text: str, words: Mapping[str, str]) -> str:
    """The sentence, or a word, in a language; `words`: what each English sentence is in it."""
    if not isinstance(text, Said):
        return words.get(text, text)
    values = {name: in_words(value, words) for name, value in text.values.items()}
    return _filled(_template(text, words), values)


def _template(text: Said, words: Mapping[str, str]) -> str:
    """What stands for the sentence's template in a language."""
    ours = words.get(text.template)
    if ours is None:
        return _english(text.template, text.values, text.one)
    if not text.one:
        return ours
    forms = ours.split(FORMS)
    return forms[min(form_of(words.get(RULE, ""), _count(text.values)), len(forms) - 1)]


def wire(text: str) -> str | dict[str, Any]:
    """What goes to the page: code (the template) and values, or plain text as it is."""
    if not isinstance(text, Said):
        return text
    values = {name: wire(value) for name, value in text.values.items()}
    counts = {"one": text.one} if text.one else {}
    return {"code": text.template, "values": values, **counts}


def from_wire(told: Any) -> str:
    """The sentence that `wire` has taken apart."""
    if not isinstance(told, Mapping):
        return str(told)
    values = {name: from_wire(value) for name, value in told["values"].items()}
    return Said(told["code"], values, told.get("one", ""))
