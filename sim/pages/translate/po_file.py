"""Catalogues of lessons as gettext's PO files: read, brought up to date, written.

The English text is the key, and stands in a catalogue once, however often the lesson says it. When
it changes, the old translation stays beside the new text, marked as fuzzy: it is not used until
somebody has looked at it. What the lesson no longer says is kept at the end of the file.
"""

from __future__ import annotations

import io
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from sim.pages.findings import AuthorError, Finding
from sim.pages.language import LANGUAGES
from sim.pages.text.author_text import author_text
from sim.pages.translate.put_in import units_alike
from sim.pages.translate.unit import Unit

if TYPE_CHECKING:
    from babel.messages.catalog import Catalog

DRAFT = '"X-Carts-State: draft\\n"'
HEAD = """\
# {file} in {name}.
# A draft, until somebody who teaches in this language has read it and taken out the line “draft”.
# The English text is the key. Formulas, links, {{attributes}} and `code` stay as they are.
# `carts words {file}` brings in what is new.
msgid ""
msgstr ""
"Language: {code}\\n"
"Content-Type: text/plain; charset=UTF-8\\n"
"Content-Transfer-Encoding: 8bit\\n"
{draft}

"""
_LINE = re.compile(r'(?:msg(?:id|str|ctxt|id_plural)(?:\[\d+\])?\s+)?"(?:[^"\\]|\\.)*"')
_HEAD_ENDS = re.compile(r"\n[ \t]*\n")
WIDTH = 100
"""Columns of a line, as in the catalogues of interface words."""


@dataclass(frozen=True, slots=True)
class Words:
    """What a catalogue says. `lines`: where each text stands in the file, counted from 1.

    `draft`: nobody has said yet that it was read. `fuzzy`: texts whose translation is an old one.
    """

    file: str
    words: Mapping[str, str]
    lines: Mapping[str, int]
    draft: bool
    fuzzy: frozenset[str]

    def place(self, text: str) -> int:
        """The line of a text, or the first."""
        return self.lines.get(text, 1)


def read_words(path: Path, file: str) -> Words:
    """The catalogue at `path`; raises `AuthorError` with its place in `file` (as messages show)."""
    return _words(author_text(path, file), file)


@lru_cache(maxsize=256)  # `carts serve` asks for every catalogue at every edit
def _words(text: str, file: str) -> Words:
    catalog = _read(text, file)
    said = {str(one.id): str(one.string) for one in catalog if one.id and one.string}
    fuzzy = frozenset(str(one.id) for one in catalog if one.id and one.fuzzy)
    return Words(
        file,
        {text: words for text, words in said.items() if text not in fuzzy},
        {str(one.id): one.lineno or 1 for one in catalog if one.id},
        DRAFT in text,
        fuzzy,
    )


def updated(path: Path, file: str, units: Sequence[Unit], language: str, source: str) -> str:
    """The text of the catalogue at `path` with every unit of its lesson; if none is there, new.

    `source`: the lesson as its head names it. Raises `AuthorError` for a file that cannot be read.
    """
    from babel.messages.catalog import Catalog
    from babel.messages.pofile import write_po

    template = Catalog()
    for text, places in units_alike(units):
        template.add(text, auto_comments=[unit.where for unit in places])
    head = HEAD.format(file=source, name=LANGUAGES[language], code=language, draft=DRAFT)
    catalog = Catalog()
    if path.is_file():
        before = author_text(path, file)
        catalog = _read(before, file)
        head = f"{_HEAD_ENDS.split(before, maxsplit=1)[0]}\n\n"
        for again in [one for one in catalog.obsolete if one in template]:
            catalog[again] = catalog.obsolete.pop(again)  # the lesson says it again
    catalog.update(template)
    for one in (*catalog, *catalog.obsolete.values()):
        one.flags -= {"python-format", "python-brace-format"}  # a % here is no placeholder
    made = io.BytesIO()
    write_po(made, catalog, width=WIDTH, omit_header=True, include_previous=True)
    return head + made.getvalue().decode("utf-8").lstrip("\n")


def _read(text: str, file: str) -> Catalog:
    from babel.messages.pofile import PoFileError, read_po  # only where there is a catalogue

    hint = "open it in Poedit, or write msgid and msgstr with quotes at both ends"
    for number, line in enumerate(text.split("\n"), start=1):  # the parser guesses at these
        if line.strip() and not line.startswith("#") and not _LINE.fullmatch(line.strip()):
            message = f"this line of a catalogue cannot be read: {line.strip()[:60]}"
            raise AuthorError([Finding(file, number, 1, "po", message, hint)])
    try:
        return read_po(io.StringIO(text), abort_invalid=True)
    except PoFileError as error:
        message = f"this catalogue cannot be read: {error}"
        finding = Finding(file, error.lineno + 1, 1, "po", message, hint)
    raise AuthorError([finding])
