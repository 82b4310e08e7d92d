"""Catalogues: what each language says, and which part of it the page's script needs."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from sim.pages.language.plurals import forms_of, key_of, rule_of
from sim.scene.said import FORMS, RULE

FOLDER = Path(__file__).parent / "catalogues"
INNER = tuple(
    f"sim/{layer}"
    for layer in ("scene", "effects", "laws", "dynamics", "worlds", "mine", "certify")
)
"""Layers that know no languages and say their sentences as templates: see sim.scene.said."""

OWN: dict[str, tuple[str, ...]] = {
    "measured": (
        *("sim/measured", "sim/bridge/measured_answer.py", "sim/view/measured"),
        *("sim/web/src/measured", "sim/web/src/film"),
    ),
    "map": (
        *("sim/scene/fence/map.py", "sim/bridge/map_answer.py"),
        *("sim/view/map", "sim/web/src/map"),
    ),
    "cost": ("sim/view/cost", "sim/web/src/cost"),
    "hard": ("sim/view/hard", "sim/web/src/hard"),
}
"""Elements that few pages have, `<carts-measured>`, and what says its sentences only in them: these
are a script of their own, `words-measured.ms.js`, which other pages need not carry."""
_ANY = tuple(place for places in OWN.values() for place in places)

ENGLISH = "en"
LANGUAGES = {
    "en": "English",
    "ms": "Bahasa Melayu",
    "ta": "தமிழ்",
    "zh-Hans": "简体中文",
}
# What a generator or a browser calls a language of ours.
_ALSO = {"zh": "zh-Hans", "zh-cn": "zh-Hans", "zh-sg": "zh-Hans", "zh-hans": "zh-Hans"}


class UnknownLanguageError(ValueError):
    """There is no catalogue of this language."""


def language_of(code: str) -> str:
    """Our name of a language: `zh` is `zh-Hans`, `ms-SG` is `ms`; raises UnknownLanguageError."""
    lowered = code.replace("_", "-").lower()
    found = _ALSO.get(lowered) or lowered.partition("-")[0]
    if found not in LANGUAGES:
        listed = ", ".join(LANGUAGES)
        raise UnknownLanguageError(f"no interface words in “{code}”: there are {listed}")
    return found


def language_folder(file: str) -> str:
    """The folder of a language that a file lies in, `worksheets/ms/a.md`: ms; "" in none."""
    return next((part for part in file.split("/")[:-1] if part in LANGUAGES), "")


def of_page(stated: object, file: str, theme: str) -> str:
    """The language of a page: what its front matter says, or the folder that it lies in, or the
    theme's. A theme may speak a language that there are no words in: English then.

    `file`: its path from the folder of mkdocs.yml. Raises UnknownLanguageError for `stated` only.
    """
    if stated is not None:
        return language_of(str(stated))
    if folder := language_folder(file):
        return folder
    try:
        return language_of(theme)
    except UnknownLanguageError:
        return ENGLISH


@cache
def words(language: str) -> Mapping[str, str]:
    """What each English sentence is in a language; empty for English."""
    return {key: said for key, (said, _) in _entries(language).items()} | _rule(language)


def words_of(language: str, folders: tuple[str, ...]) -> dict[str, str]:
    """Those of `words` that the sources in these folders say."""
    return _where(language, lambda places: _any_in(places, folders)) | _rule(language)


@cache
def words_script(language: str) -> str:
    """A script that gives the page its words; "" where it needs none."""
    found = _where(language, lambda places: any(map(_in_page, places)))
    if not found:
        return ""
    return f"globalThis.cartsWords={_as_json(found | _rule(language))};\n"


@cache
def own_words_script(element: str, language: str) -> str:
    """A script that adds what only pages with an element of `OWN` say; it stands behind the other
    one."""
    own = OWN[element]
    found = _where(language, lambda places: _any_in(places, own) and not any(map(_in_page, places)))
    return f"Object.assign(globalThis.cartsWords,{_as_json(found)});\n" if found else ""


def _where(language: str, fits: Callable[[tuple[str, ...]], bool]) -> dict[str, str]:
    """The words whose places in the sources fit."""
    return {key: said for key, (said, places) in _entries(language).items() if fits(places)}


def _any_in(places: tuple[str, ...], folders: tuple[str, ...]) -> bool:
    return any(place.startswith(folders) for place in places)


def _as_json(found: Mapping[str, str]) -> str:
    return json.dumps(found, ensure_ascii=False, sort_keys=True, separators=(",", ":"))


@cache
def _entries(language: str) -> Mapping[str, tuple[str, tuple[str, ...]]]:
    """Sentence → what is said, and the files that say it. The key of one that counts is its form
    for more, and all forms are said."""
    if language == ENGLISH:
        return {}
    return {
        key_of(entry.id): (FORMS.join(forms), tuple(name for name, _ in entry.locations))
        for entry in read(language)
        if entry.id and all(forms := forms_of(entry.string)) and not entry.fuzzy
    }


@cache
def read(language: str) -> Any:
    """The catalogue of a language, as its file has it."""
    from babel.messages.pofile import read_po  # only a page in another language needs it

    with (FOLDER / f"{language}.po").open("rb") as file:
        return read_po(file, locale=language.replace("-", "_"))


@cache
def _rule(language: str) -> dict[str, str]:
    """Which form each number takes, under its key; nothing for English."""
    return {} if language == ENGLISH else {RULE: rule_of(read(language).plural_expr)}


def _in_page(location: str) -> bool:
    """Whether a page says it whatever stands on it: scripts say it themselves; what the inner
    layers say of a run passes through them."""
    inside = location.endswith(".js") or location.startswith(INNER)
    return inside and not location.startswith(_ANY)
