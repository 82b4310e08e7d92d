"""What of our wheel is not in the picture of the memory: a few modules that need numpy or scipy.

A page that starts from the picture and has such a package loads and unpacks these alone.
"""

from __future__ import annotations

import zipfile
from collections.abc import Iterable
from pathlib import Path

from .cache import Cache, key_of
from .node import code_key
from .ours import NAME, Ours

REST = f"{NAME}-rest"


def make_rest_wheel(wheel: Path, later: Iterable[str], ours: Ours, cache: Cache) -> Path:
    """Return the wheel of the modules `later` and all below them, out of the compiled `wheel`."""
    folders = tuple(f"{name.replace('.', '/')}/" for name in later)
    files = {f"{folder[:-1]}.pyc" for folder in folders}
    rest = Ours((), ours.version, REST)

    def make(folder: Path) -> None:
        target = folder / rest.wheel_name
        rest.write_wheel(target)
        with zipfile.ZipFile(wheel) as source, zipfile.ZipFile(target, "a") as out:
            for info in source.infolist():
                if info.filename in files or info.filename.startswith(folders):
                    out.writestr(info, source.read(info))

    key = key_of(code_key("rest_wheel", "ours"), ours.key, wheel.parent.name, *sorted(files))
    return cache.step("rest", key, make) / rest.wheel_name
