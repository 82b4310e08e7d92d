"""Runtimes that a wheel carries ready-made, one for each set of packages that a site may need.

All of them share their scripts; an entry `NUMBER.json` names those of one set, with its index. They
were made from the same sources as the wheel: if those have been changed since, nothing is ready.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from . import pins
from .cache import Cache, key_of, sha256
from .contents import Contents, make_contents
from .extras import EXTRAS, read_extras
from .node import RuntimePackError
from .ours import (
    CLASSROOM,
    MEASURED,
    OWN_LAW,
    PROOF,
    TEACHER,
    WORLDS,
    Ours,
    read_ours,
    text_bytes,
)
from .sources import core_files, package_wheels
from .stdlib import core_folder
from .teacher import own_files

SETS: tuple[frozenset[str], ...] = tuple(
    frozenset({PROOF, *more})
    for more in (
        (),
        (TEACHER,),
        (WORLDS, TEACHER),
        ("numpy", TEACHER),
        (OWN_LAW, WORLDS, TEACHER),
        ("numpy", "scipy", TEACHER),
        ("numpy", "scipy", MEASURED, TEACHER),
        ("numpy", "scipy", CLASSROOM, MEASURED, OWN_LAW, WORLDS, TEACHER),
    )
)
"""From small to large. A site takes of the first that has all it needs what it needs."""

HELP = "Install it again: pip install --force-reinstall newtons-carts"


class DamagedError(RuntimePackError):
    """A file of the installed wheel is not what it was."""


def write_ready(folder: Path, package: Path, version: str, cache: Path,
                report: Callable[[str], None]) -> None:  # fmt: skip
    """Write the runtimes of all `SETS` into `folder`; raises RuntimePackError."""
    folder.mkdir(parents=True, exist_ok=True)
    store = Cache(cache)
    ours = read_ours(package, version)
    files = core_files(store, package.parent, report)
    core = core_folder(files, store)
    for number, names in enumerate(SETS):
        wanted = [name for name in pins.PACKAGES if name in names]
        wheels = package_wheels(wanted, files[pins.LOCK], files[pins.LOADER], store, report)
        extras = read_extras(names, package, version)
        made = make_contents(core, ours, wheels, store, report, extras)
        for name, path in made.scripts.items():
            shutil.copyfile(path, folder / name)
        entry = {
            "packages": sorted(names),
            "sources": _sources(ours, package),
            "scripts": {n: sha256(path.read_bytes()) for n, path in sorted(made.scripts.items())},
            "index": made.index,
            "versions": made.versions,
        }
        text = json.dumps(entry, indent=1, sort_keys=True)
        (folder / f"{number}.json").write_text(text, encoding="utf-8")


def find_ready(
    folder: Path, packages: frozenset[str], ours: Ours, package: Path
) -> Contents | None:
    """The smallest ready runtime with `packages`, cut down to them. Raises DamagedError."""
    for path in sorted(folder.glob("*.json")):
        entry = _entry(path)
        if packages <= set(entry["packages"]):
            if entry["sources"] != _sources(ours, package):
                raise DamagedError(f"The installed newtons-carts is mixed of two versions. {HELP}")
            check_entry(path)
            return _only(packages, entry, folder)
    return None


def _only(packages: frozenset[str], entry: dict[str, Any], folder: Path) -> Contents:
    """A set without the packages that nobody asked for: a site carries, and names the licences of,
    what it needs. The lock may name more: what the index does not have is never loaded."""
    index: dict[str, Any] = entry["index"]
    kept = packages | ({"numpy"} if "scipy" in packages else set())
    left = set(entry["packages"]) - kept
    wheels = {name: file for name, file in index["wheels"].items() if name not in left}
    gone = {index["wheels"][name] for name in left if name in index["wheels"]}
    files = {name: file for name, file in index["files"].items() if name not in gone}
    named = {part["src"] for name in gone for part in index["files"][name]["parts"]}
    scripts = {name: folder / name for name in entry["scripts"] if name not in named}
    versions = {name: told for name, told in entry["versions"].items() if name not in left}
    return Contents(scripts, {**index, "files": files, "wheels": wheels}, versions)


def check_entry(path: Path) -> int:
    """How many scripts one set has, all as they were made. Raises DamagedError."""
    scripts: dict[str, str] = _entry(path)["scripts"]
    for name, digest in scripts.items():
        script = path.parent / name
        if not script.is_file() or sha256(script.read_bytes()) != digest:
            raise DamagedError(f"{name} of the installed newtons-carts is damaged. {HELP}")
    return len(scripts)


def _entry(path: Path) -> dict[str, Any]:
    try:
        entry: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        text = f"{path.name} of the installed newtons-carts is damaged. {HELP}"
        raise DamagedError(text) from None
    return entry


def _sources(ours: Ours, package: Path) -> str:
    """What the sets were made from; of teacher mode its own files, not the packages below it."""
    extras = (read for name, read in EXTRAS.items() if name != TEACHER)
    own = (read(package, ours.version) for read in extras)
    teacher = sorted(sha256(text_bytes(path)) for path in own_files(package))
    return key_of(ours.key, *(extra.key for extra in own), *teacher)
