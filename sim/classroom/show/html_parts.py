"""Pieces of a report's HTML. Everything that came out of a file is escaped here, by `text`."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence

from sim.classroom.show.escaped import escape
from sim.scene.said import in_words

Tell = Callable[[str], str]
"""A sentence of ours as HTML text, in the language of the report or paper."""

_MARKDOWN = re.compile(r"\*\*|__|`|\\[()]")
LONGEST = 2000


def text(value: object) -> str:
    """Any value as text of a page, with the marks of Markdown taken out."""
    plain = _MARKDOWN.sub("", str(value))
    plain = plain if len(plain) <= LONGEST else f"{plain[:LONGEST]}…"
    return escape(plain)


def telling(words: Mapping[str, str]) -> Tell:
    """`words`: what each English sentence is in the language; empty for English."""
    return lambda sentence: text(in_words(sentence, words))


def who(value: object) -> str:
    """A name that somebody typed: kept apart, so that its direction changes nothing around it."""
    return f"<bdi>{text(value)}</bdi>"


def table(head: Sequence[str], rows: Iterable[Sequence[str]], *, kind: str = "") -> str:
    """A table; cells are HTML already."""
    header = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    body = "".join(f"<tr>{''.join(f'<td>{cell}</td>' for cell in row)}</tr>" for row in rows)
    return (
        f'<div class="carts-class-table {kind}" tabindex="0"><table class="carts-class-cells">'
        f"<thead><tr>{header}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def person(name: str, tell: Tell) -> str:
    """The same for one that may be a sentence of ours: a file without a code word."""
    return f"<bdi>{tell(name)}</bdi>"


def listed(sentences: Iterable[str], tell: Tell, kind: str = "says") -> str:
    """Sentences as a list, or nothing."""
    items = "".join(f"<li>{tell(sentence)}</li>" for sentence in sentences if sentence)
    return f'<ul class="carts-class-{kind}">{items}</ul>' if items else ""
