"""A page in one file: Python's scripts stand in the page itself."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
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
