"""Faults of a folder, a browser and a server, each done to a copy of the site's lesson.

What must be seen: everything works, or something says that it does not. Nothing else is a verdict.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

Harm = Callable[[Path], None]


@dataclass(frozen=True)
class Fault:
    """A name for the table, what is done to the folder, and what the page's browser lacks.

    `without`: a script that runs before the page's own. `mode`: how the page is opened, from
    "disk" or "http", in a folder of this name.
    """

    name: str
    harm: Harm = lambda _: None
    without: str = ""
    mode: str = "disk"
    folder: str = "site"


def missing(file: Path) -> None:
    file.unlink()


def cut(file: Path) -> None:
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def flipped(file: Path) -> None:
    """One bit, at a place that is the same in every run."""
    content = bytearray(file.read_bytes())
    place = random.Random(file.name.partition(".")[0]).randrange(len(content))
    content[place] ^= 4
    file.write_bytes(content)


def empty(file: Path) -> None:
    file.write_bytes(b"")


SCRIPTS = ("carts.js", "answers.js")
RUNTIME = ("index.js", "pyodide.js.*", "pyodide.asm.wasm.*", "memory.snapshot.*", "python.zip.*")
LACKS = {
    "no WebAssembly": "delete window.WebAssembly",
    "no workers": "delete window.Worker",
    "no decompression": "delete window.DecompressionStream",
    "no storage at all": "for (const name of ['indexedDB', 'localStorage'])"
    " Object.defineProperty(window, name, { get() { throw new DOMException('', 'SecurityError') }"
    " })",
    "a store that is full": "IDBObjectStore.prototype.put = () => {"
    " throw new DOMException('', 'QuotaExceededError') }; Storage.prototype.setItem = () => {"
    " throw new DOMException('', 'QuotaExceededError') }",
    "a store that never opens": "indexedDB.open = () => new EventTarget()",
    "no memory for Python": "WebAssembly.Memory = function () { throw new RangeError('memory') }",
    "a clock in 1980": "const now = Date.now; Date.now = () => now() - 1.45e12",
    "a clock in 2080": "const now = Date.now; Date.now = () => now() + 1.7e12",
    "no hashes, as on plain http": "Object.defineProperty(crypto, 'subtle', { value: undefined })",
}
FOLDERS = ("with blank", "100% done", "naïve #1 & co", "物理", "a+b=c;d", "q?uestion")


def faults() -> Iterator[Fault]:
    """All of them, the same in every run."""
    yield Fault("nothing")
    for harm in (missing, cut, flipped, empty):
        for script in SCRIPTS:
            yield Fault(f"{script} {harm.__name__}", _to(harm, script))
        for part in RUNTIME:
            yield Fault(f"runtime: {part} {harm.__name__}", _to(harm, f"runtime/{part}"))
    for name, script in LACKS.items():
        yield Fault(name, without=script)
    for folder in FOLDERS:
        yield Fault(f"a folder called “{folder}”", folder=folder)
    yield Fault("from a server", mode="http")
    yield Fault("a server half updated: another runtime", _to(missing, "runtime/p*"), mode="http")
    yield Fault("a login page for every script", _to(_login, "*.js"), mode="http")
    yield Fault("a folder that nobody may write", lambda site: site.chmod(0o555))


def _login(file: Path) -> None:
    file.write_text("<!doctype html><title>Log in</title>", encoding="utf-8")


def _to(harm: Harm, pattern: str) -> Harm:
    def done(site: Path) -> None:
        for file in (site / "assets" / "carts").glob(pattern):
            harm(file)

    return done
