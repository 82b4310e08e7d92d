"""Which files `carts class` reads, in which order, and to which group each belongs."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from fnmatch import fnmatchcase
from pathlib import Path, PurePosixPath

from sim.classroom.files.archive import LARGEST, MOST_UNPACKED, is_zip
from sim.classroom.files.reading import Source

ENDINGS = (".json", ".zip")
OF_TABLES = (".csv", ".tsv", ".xlsx", ".xls", ".ods")
MOST_ZIP = MOST_UNPACKED


def tables_in(paths: Iterable[Path]) -> Iterator[Path]:
    """Tables of marks that lie in named folders: who reads answer files passes over them."""
    for folder in filter(Path.is_dir, paths):
        yield from _inside(folder, OF_TABLES)


def sources(paths: Iterable[Path]) -> Iterator[Source]:
    """Files as they are named, folders with all answer files and zips in them."""
    for path in paths:
        if path.is_dir():
            yield from map(_source, _inside(path, ENDINGS))
        else:
            yield _source(path)


def _inside(folder: Path, endings: Sequence[str]) -> Iterator[Path]:
    """Files with one of these endings, sorted; of 100,000 one folder's names are held, no tree."""
    with os.scandir(folder) as found:
        names = sorted((entry.name, entry.is_dir(follow_symlinks=False)) for entry in found)
    for name, is_folder in names:
        path = folder / name
        if is_folder:
            yield from _inside(path, endings)
        elif path.suffix.lower() in endings and path.is_file():
            yield path


def _source(path: Path) -> Source:
    """At most what may be looked at: what is larger is refused by its size."""
    try:
        with path.open("rb") as file:
            start = file.read(4)
            return Source(
                path.as_posix(), start + file.read(MOST_ZIP if is_zip(start) else LARGEST)
            )
    except OSError as error:
        return Source(f"{path.as_posix()} ({error.strerror})", b"")


def with_slashes(text: str, windows: bool = os.name == "nt") -> str:
    """A path as it is named here; Windows' Tab key writes 7a\\ann.json."""
    return text.replace("\\", "/") if windows else text


def group_of(name: str, groups: Sequence[tuple[str, str]]) -> str:
    """The first group whose pattern fits the name, its end, or its file name; empty: none. A folder
    that is called so comes before what its name would fit as a pattern: [7a]."""
    path = PurePosixPath(name)
    ends = ["/".join(path.parts[k:]) for k in range(len(path.parts))]
    for group, pattern in groups:
        wanted = pattern.removeprefix("./").rstrip("/")
        named = any(f"{end}/".startswith(f"{wanted.removesuffix('/*')}/") for end in ends)
        if named or any(fnmatchcase(end, one) for end in ends for one in (wanted, f"{wanted}/*")):
            return group
    return ""
