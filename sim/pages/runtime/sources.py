"""Where Pyodide's files come from: the cache, the npm package, Pyodide's own server, or pip.

Each place is asked in turn for what is still missing; a file counts only if its sha256 is the one
in pins.py or in Pyodide's lock file, wherever it came from.
"""

from __future__ import annotations

import json
import os
import tarfile
import zipfile
import zlib
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from . import pins
from .cache import Cache, sha256
from .node import RuntimePackError
from .places import Place, from_carrier, from_cdn, from_node_modules, from_npm

Report = Callable[[str], None]


class MissingSourceError(RuntimePackError):
    """A file of Pyodide is nowhere to be had."""


@dataclass(frozen=True)
class Wanted:
    """A file by name and sha256."""

    name: str
    sha256: str


CORE = tuple(Wanted(name, digest) for name, digest in pins.CORE.items())


def core_files(cache: Cache, repository: Path, report: Report) -> dict[str, Path]:
    """Return the files of Pyodide itself, by name. Raises MissingSourceError."""
    places = [from_node_modules(repository / "node_modules" / "pyodide"), from_npm()]
    return collect(CORE, places, cache, report)


def package_wheels(
    names: Iterable[str], lock: Path, loader: Path, cache: Cache, report: Report
) -> dict[str, Path]:
    """Return the distribution's wheels by package name. Raises MissingSourceError."""
    names = tuple(names)
    listed = json.loads(lock.read_text(encoding="utf-8"))["packages"]
    wanted = [Wanted(listed[n]["file_name"], listed[n]["sha256"]) for n in names]
    found = collect(wanted, [from_cdn(loader), from_carrier()], cache, report)
    return {n: found[w.name] for n, w in zip(names, wanted, strict=True)}


def collect(
    wanted: Iterable[Wanted], places: Iterable[Place], cache: Cache, report: Report
) -> dict[str, Path]:
    """Return every wanted file from the cache, asking the places in order for what is not there."""
    wanted = tuple(wanted)
    found = {w.name: path for w in wanted if (path := cache.find(w.sha256))}
    refused: list[str] = []
    for place in places:
        missing = [w for w in wanted if w.name not in found]
        if not missing:
            break
        report(f"Looking for {_names(missing)} in {place.what}")
        with cache.workspace() as folder:
            try:
                offered = place.fetch([w.name for w in missing], folder, report)
                for w in missing:
                    data = offered.get(w.name)
                    if data is not None and sha256(data) == w.sha256:
                        found[w.name] = cache.keep(data)
                    elif data is not None:
                        refused.append(f"{place.what}: {w.name} has the wrong sha256")
            except (OSError, RuntimePackError) as error:
                refused.append(f"{place.what}: {error}")
            except (StopIteration, EOFError, zlib.error, tarfile.TarError, zipfile.BadZipFile):
                refused.append(f"{place.what}: what came is cut or damaged")
    missing = [w for w in wanted if w.name not in found]
    if missing:
        raise MissingSourceError(_complaint(missing, refused, cache))
    return {w.name: found[w.name] for w in wanted}


def _names(wanted: Iterable[Wanted]) -> str:
    return ", ".join(w.name for w in wanted)


def _complaint(missing: list[Wanted], refused: list[str], cache: Cache) -> str:
    lines = [f"Python for the page (Pyodide {pins.PYODIDE}) is not complete. Missing:"]
    lines += [f"  {w.name}  (sha256 {w.sha256})" for w in missing]
    lines += ["Tried:", *(f"  {line}" for line in refused)]
    lines += [
        "What helps: run the build once with a network; or copy the folder"
        f" {cache.root / 'sources'} from a computer where the build works.",
    ]
    return "\n".join(lines)


def in_ci() -> bool:
    """Whether this is an automatic build, in which a missing source is an error, never a skip."""
    return os.environ.get("CI", "").lower() in {"1", "true", "yes"}
