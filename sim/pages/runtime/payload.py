"""Bytes as classic scripts: what a page on file:// can load, and nothing else.

Each file is gzipped, cut into parts and written as base64 in scripts of about one and a half
megabytes. Parts keep the page smooth (no long parse), show progress on a slow line, and can be
checked one by one. Their names carry their hash: a cache can't mix two builds.
"""

from __future__ import annotations

import base64
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sim.pages.gzipped import gzipped

from .cache import sha256

PART_BYTES = 3 * 384 * 1024  # of gzip; a multiple of 3, so that no part needs base64 padding


@dataclass(frozen=True)
class Part:
    """One script: its file name, and the sha256 and length of the gzip bytes it holds."""

    src: str
    sha256: str
    size: int


@dataclass(frozen=True)
class Payload:
    """A file of `size` bytes, to be put together from its parts and gunzipped."""

    name: str
    size: int
    parts: tuple[Part, ...]

    def as_json(self) -> dict[str, object]:
        """The entry in index.js."""
        return {"size": self.size, "parts": [vars(part) for part in self.parts]}


def payload_from_json(name: str, entry: dict[str, Any]) -> Payload:
    """Return the payload that `as_json` described."""
    return Payload(name, entry["size"], tuple(Part(**part) for part in entry["parts"]))


def write_payload(name: str, data: bytes, folder: Path) -> Payload:
    """Write `data` as scripts into `folder`."""
    payload, scripts = make_payload(name, data)
    for src, text in scripts.items():
        (folder / src).write_text(text, encoding="ascii", newline="\n")
    return payload


def make_payload(name: str, data: bytes) -> tuple[Payload, dict[str, str]]:
    """The payload of `data`, and its scripts by file name."""
    packed = gzipped(data)
    parts, scripts = [], {}
    for number, start in enumerate(range(0, len(packed), PART_BYTES)):
        chunk = packed[start : start + PART_BYTES]
        digest = sha256(chunk)
        key = f"{name}.{number}"
        src = f"{key}.{digest[:12]}.js"
        text = base64.b64encode(chunk).decode("ascii")
        scripts[src] = f'(self.__cartsParts??={{}})[{json.dumps(key)}]="{text}";\n'
        parts.append(Part(src, digest, len(chunk)))
    return Payload(name, len(data), tuple(parts)), scripts


def write_index(index: dict[str, object], folder: Path) -> None:
    """Write index.js, the table of contents that the page reads first."""
    text = json.dumps(index, indent=1, sort_keys=True)
    (folder / "index.js").write_text(
        f"self.__cartsRuntime = {text};\n", encoding="utf-8", newline="\n"
    )
