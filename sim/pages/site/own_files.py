"""Only files of the site itself join it: a link may lead to anything on an author's computer."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path


def strangers(folders: Iterable[Path]) -> list[Path]:
    """What in the folders is a link that leads out of its folder, or to nothing.

    A fork of somebody else's site is not to be trusted: with such a link its author would get a
    file of the person who builds it into the zip.
    """
    found = []
    for folder in folders:
        home = folder.resolve()
        for where, inner, names in os.walk(folder, followlinks=False):
            for path in (Path(where, name) for name in (*inner, *names)):
                if not path.is_symlink():
                    continue
                target = path.resolve()
                if not target.exists() or not target.is_relative_to(home):
                    found.append(path)
    return sorted(found)
