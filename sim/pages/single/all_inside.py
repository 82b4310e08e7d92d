"""A page in one file: its scripts stand in the page itself, each allowed by its hash, no other."""

from __future__ import annotations

import base64
import hashlib
import html
import tempfile
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

from sim.pages import runtime
from sim.pages.findings import SiteError

INSIDE = "self.__cartsInside = true;"
"""Stands before the runtime's scripts: they are not to be asked for by address."""


def runtime_scripts(
    packages: frozenset[str], root: Path, report: Callable[[str], None]
) -> list[str]:
    """The runtime's table of contents and every part that it names; raises SiteError."""
    return list(runtime_files(packages, root, report).values())


def runtime_files(
    packages: frozenset[str], root: Path, report: Callable[[str], None]
) -> dict[str, str]:
    """The same by file name."""
    with tempfile.TemporaryDirectory() as folder:
        cache = runtime.default_cache(root)
        try:
            packed = runtime.pack(Path(folder), packages=packages, cache=cache, report=report)
        except runtime.ERRORS as error:
            raise SiteError(str(error)) from error
        if packed.missing:
            raise SiteError(packed.missing)
        names = sorted(packed.files)
        return {name: (packed.folder / name).read_text(encoding="utf-8") for name in names}


def policy(
    styles: Iterable[str], scripts: Iterable[str], more: Mapping[str, str] | None = None
) -> str:
    """The content security policy, as the value of an attribute. `more`: rules beside these."""

    def named(texts: Iterable[str]) -> str:
        hashes = (hashlib.sha256(text.encode()).digest() for text in texts)
        return " ".join(f"'sha256-{base64.b64encode(h).decode()}'" for h in hashes)

    rules = {
        "default-src": "'none'",
        "script-src": f"'wasm-unsafe-eval' {named(scripts)}",
        "style-src": named(styles),
        "img-src": "data: blob:",
        "worker-src": "blob:",
        "base-uri": "'none'",
        "form-action": "'none'",
        **(more or {}),
    }
    return html.escape("; ".join(f"{key} {value}" for key, value in rules.items()), quote=True)
