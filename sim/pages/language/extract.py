"""Finds every interface sentence in the sources and keeps the catalogues complete.

`make words` writes new sentences into each `.po` file, untranslated, and takes those away that
nobody says any more. A test compares, and names what is missing.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

from babel.messages import Catalog
from babel.messages.extract import extract_from_file
from babel.messages.pofile import write_po

from sim.pages.language.catalogue import (
    ENGLISH,
    FOLDER,
    INNER,
    LANGUAGES,
    read,
)
from sim.pages.language.plurals import forms_of, key_of

ROOT = Path(__file__).parents[3]
# Folders that are looked through, with the method for each kind of file in them and the functions
# whose text is for readers.
INNER_CALLS = ("said", "template", "Field", "Dimension", "_dimension")
"""Calls of the inner layers whose first argument readers see: sentences, names of numbers."""

ERRORS = (
    "RefusalError",
    "KeyFileError",
    "MarksFileError",
    "TableError",
    "SummaryError",
    "CountryError",
    "AnswerFileError",
    "HandInError",
    "_DamagedError",
)
"""Errors whose message a teacher reads in a report."""

COUNTED = ("counted", "tr_counted")
"""Calls with two forms of a sentence: for one, and for more."""

SOURCES = (
    ("sim/pages", "*.py", "python", ("tr", "tr_html", "mark")),
    ("sim/pages", "*.j2", "jinja2.ext.babel_extract", ("tr",)),
    ("sim/view", "*.js", "javascript", ("tr",)),
    ("sim/effects", "*.js", "javascript", ("tr",)),
    ("sim/web/src", "*.js", "javascript", ("tr",)),
    ("sim/classroom", "*.py", "python", ("said", "template", *ERRORS)),
    ("sim/country", "*.py", "python", ("said", "template", *ERRORS)),
    ("sim/cli/classroom", "*.py", "python", ("said", "template")),
    ("sim/lesson", "*.py", "python", ("said", "template", *ERRORS)),
    ("sim/measured", "*.py", "python", ("said", "template")),
    ("sim/bridge", "*.py", "python", ("said",)),
    *((folder, "*.py", "python", INNER_CALLS) for folder in INNER),
)
OPTIONS: dict[str, dict[str, Any]] = {
    ".j2": {"trim_blocks": "true"},
    ".js": {"parse_template_string": True},
}
HEAD = """\
# Interface words of Newton's Carts: {name}.
# The English sentence is the key. What stands in {{braces}} stays as it is, at the place where it
# belongs in this language. `make words` brings new sentences; the tests name those not translated.
msgid ""
msgstr ""
"Language: {code}\\n"
"Content-Type: text/plain; charset=UTF-8\\n"
"Content-Transfer-Encoding: 8bit\\n"
"Plural-Forms: {rule}\\n"

"""


def sentences() -> dict[str, list[str]]:
    """Every sentence, by its key in the catalogues, with the files that say it; sorted."""
    return {key_of(sentence): files for sentence, files in _found().items()}


def counted_sentences() -> dict[str, str]:
    """Of each sentence that counts: its form for more and its form for one. For tests."""
    return {pair[1]: pair[0] for pair in _found() if isinstance(pair, tuple)}


@cache
def _found() -> dict[str | tuple[str, ...], list[str]]:
    found: dict[str | tuple[str, ...], set[str]] = {}
    for file, sentence in _everywhere():
        found.setdefault(sentence, set()).add(file)
    return {sentence: sorted(found[sentence]) for sentence in sorted(found, key=key_of)}


def _everywhere() -> Iterator[tuple[str, str | tuple[str, ...]]]:
    for folder, pattern, method, functions in SOURCES:
        asked = {**dict.fromkeys(functions), **dict.fromkeys(COUNTED, (1, 2))}
        calls = re.compile(rf"\b(?:{'|'.join(asked)})\s*\(")
        for path in sorted((ROOT / folder).rglob(pattern)):
            if not calls.search(path.read_text(encoding="utf-8")):
                continue  # more than half of the files say nothing: a search is soon done
            options = OPTIONS.get(path.suffix, {})
            for _, message, _, _ in extract_from_file(
                method, path, keywords=asked, options=options
            ):
                if isinstance(message, tuple) or message:
                    yield path.relative_to(ROOT).as_posix(), message


def updated(language: str) -> Catalog:
    """The catalogue of a language with every sentence of the sources and no other.

    Its forms are those that the file names in its head (`Plural-Forms`); a new one gets gettext's.
    """
    before = read(language) if (FOLDER / f"{language}.po").exists() else None
    made = Catalog(locale=language.replace("-", "_"))
    if before:
        made.mime_headers = [("Plural-Forms", before.plural_forms)]
    for sentence, files in _found().items():
        old = before.get(sentence) if before else None
        places: list[Any] = [(file, None) for file in files]  # no lines: they change too often
        forms = isinstance(sentence, tuple)
        same = old if old and not old.fuzzy and old.pluralizable == forms else None
        made.add(sentence, same.string if same else "", locations=places)
    return made


def names_in(sentence: str) -> set[str]:
    """The names in braces that a sentence has. For tests of the catalogues."""
    return set(re.findall(r"\{(\w+)\}", sentence))


def main() -> None:
    """Brings every catalogue up to date and says what is left to do."""
    for language in LANGUAGES:
        if language == ENGLISH:
            continue
        catalog = updated(language)
        with (FOLDER / f"{language}.po").open("wb") as file:
            head = {"name": LANGUAGES[language], "code": language, "rule": catalog.plural_forms}
            file.write(HEAD.format(**head).encode())
            write_po(file, catalog, width=100, omit_header=True, sort_output=True)
        left = [entry for entry in catalog if entry.id and not all(forms_of(entry.string or ""))]
        print(f"{language}: {len(catalog)} sentences, {len(left)} not translated yet")


if __name__ == "__main__":
    main()
