"""third-party-licenses.txt: what a built site carries of other people's work, and the terms."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from importlib import metadata
from pathlib import Path, PurePosixPath
from typing import Any

import yaml

FILE_NAME = "third-party-licenses.txt"

_HERE = Path(__file__).parent
_RULE = "=" * 80
_HEAD = """\
What this site carries of other people's work
{rule}

Newton's Carts itself: code Apache-2.0, lessons CC BY 4.0. This folder also holds the works listed
here, each under its own terms. The texts of the licences follow the list.
"""


@dataclass(frozen=True, slots=True)
class Notice:
    """One work: its name and version, where its source is, under which terms, and their texts."""

    name: str
    version: str
    source: str
    licence: str
    copyright: str
    note: str
    texts: tuple[tuple[str, str], ...]  # title and text
    package: str  # where its version is from: `npm:katex`, `numpy` of pip; "" or a number: neither

    def __str__(self) -> str:
        lines = [f"{self.name} {self.version}".rstrip(), f"  licence: {self.licence}"]
        lines += [f"  {self.copyright}"] if self.copyright else []
        lines += [f"  source: {self.source}"]
        lines += [f"  {self.note}"] if self.note else []
        return "\n".join(lines)


def notices(node_modules: Path, *, scenes: bool, packages: Iterable[str] = ()) -> Iterator[Notice]:
    """The works in a site: with the Python runtime if it has `scenes`, and with `packages`."""
    parts = {"site", *(["scenes"] if scenes else []), *packages}
    for row in _rows():
        if row["in"] in parts:
            version = _version(row.get("version", ""), node_modules)
            yield Notice(
                row["name"],
                version,
                row["source"].format(version=version),
                row["licence"],
                row.get("copyright", ""),
                row.get("note", ""),
                tuple(_texts(row, node_modules)),
                row.get("version", ""),
            )


def all_notices(node_modules: Path) -> Iterator[Notice]:
    """The works in a site that has everything."""
    return notices(node_modules, scenes=True, packages={row["in"] for row in _rows()})


def npm_packages() -> list[str]:
    """The packages from npm whose version or licence text is asked for."""
    rows = _rows()
    named = {row.get(key, "") for row in rows for key in ("version", "from")}
    return sorted(n.removeprefix("npm:") for n in named if n.startswith("npm:"))


def licence_file(works: Iterable[Notice]) -> str:
    """The whole file: the list, then every text once."""
    works = list(works)
    texts: dict[str, str] = {}
    for work in works:
        texts.update(work.texts)
    parts = [_HEAD.format(rule=_RULE), *(f"{work}\n" for work in works)]
    parts += [f"{_RULE}\n{title}\n{_RULE}\n\n{text.strip()}\n" for title, text in texts.items()]
    return "\n".join(parts)


@cache
def _rows() -> tuple[dict[str, Any], ...]:
    return tuple(yaml.safe_load((_HERE / "notices.yml").read_text(encoding="utf-8")))


def _version(named: str, node_modules: Path) -> str:
    """A version as written, or that of the package named: `npm:katex`, `numpy`."""
    if named.startswith("npm:"):
        package = node_modules / named.removeprefix("npm:") / "package.json"
        return str(json.loads(package.read_text(encoding="utf-8"))["version"])
    if not named or named[0].isdigit():
        return named
    return metadata.version(named)


@cache
def _licences_of(package: str) -> tuple[PurePosixPath, ...]:
    """The licence texts of an installed package; its list of files is long, and read once."""
    listed = metadata.distribution(package).read_text("RECORD") or ""
    its_own = (PurePosixPath(row[0]) for row in csv.reader(listed.splitlines())
               if ".dist-info/" in row[0])  # fmt: skip
    return tuple(
        path
        for path in its_own
        if path.parts[0].endswith(".dist-info")
        and ("licenses" in path.parts or path.name.startswith("LICENSE"))
    )


def _texts(row: dict[str, Any], node_modules: Path) -> Iterator[tuple[str, str]]:
    kind, _, package = row.get("from", "").partition(":")
    if kind == "npm":
        path = node_modules / package / "LICENSE"
        yield f"{row['name']}: {row['licence']}", path.read_text(encoding="utf-8")
    elif kind == "pip":
        for path in _licences_of(package):
            place = Path(str(metadata.distribution(package).locate_file(path)))
            text = place.read_text(encoding="utf-8")
            yield f"{row['name']}: {'/'.join(path.parts[1:])}", text
    named = row.get("text", [])
    for name in [named] if isinstance(named, str) else named:
        yield name, (_HERE / f"{name}.txt").read_text(encoding="utf-8")
