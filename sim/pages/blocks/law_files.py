"""Laws in Python files beside a lesson or a scene: their texts go into the scene."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from sim.pages.text.author_text import author_text, shown_here
from sim.scene.reading.written import named_laws

MOST_BYTES = 100_000
"""A law has some 300; what is longer is refused when it is read."""


def with_law_files(
    plain: Mapping[str, Any], folders: Iterable[Path], texts: Mapping[str, str] | None = None
) -> dict[str, Any]:
    """The plain scene with the texts of the laws that it names, from the first of `folders`.

    `texts`: laws that are there already. What is missing stays so: the scene's reader says it.
    Raises `AuthorError`, at its line, for one that is not UTF-8.
    """
    own = plain.get("laws", {})
    if not isinstance(own, Mapping):
        return dict(plain)
    found = {**(texts or {}), **own}
    asked = {name for _, name in named_laws(plain.get("contact"))}
    for name in sorted(asked - set(found)):
        path = next((folder / name for folder in folders if (folder / name).is_file()), None)
        if path is not None and path.stat().st_size <= MOST_BYTES:
            found[name] = author_text(path, shown_here(path))
    laws = {name: text for name, text in found.items() if name in asked or name in own}
    return {**plain, "laws": laws} if laws else dict(plain)
