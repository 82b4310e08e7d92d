"""Python's standard library as bytecode, and the part of it that a page really uses.

Pyodide ships it as source text, which the page would compile at every start. Compiled without
docstrings and cut down to what is imported, a plain start takes a third of the time.
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from . import pins
from .cache import Cache, key_of
from .node import INSIDE, code_key, run_script, tools_key

DATE = (1980, 1, 1, 0, 0, 0)
NO_DOCSTRINGS = 2  # as `python -OO`

# Used by what a page may do although nothing imports it at the start: kept whatever was recorded.
ALWAYS = ("encodings.ascii", "encodings.cp437", "encodings.latin_1", "random", "traceback")


@dataclass(frozen=True)
class Used:
    """Files of the standard library in use, and modules of ours that wait for numpy or scipy."""

    files: tuple[str, ...]
    later: tuple[str, ...]


def core_folder(files: dict[str, Path], cache: Cache) -> Path:
    """Return a folder with Pyodide's files as its loader in Node expects them."""

    def make(folder: Path) -> None:
        for name, path in files.items():
            (folder / name).write_bytes(path.read_bytes())
        # The loader asks for this web-socket package at once, to use it never.
        stub = folder / "node_modules" / "ws"
        stub.mkdir(parents=True)
        (stub / "package.json").write_text('{"name": "ws", "main": "index.js"}', encoding="utf-8")
        (stub / "index.js").write_text("module.exports = {};\n", encoding="utf-8")

    return cache.step("core", key_of(*pins.CORE.values()), make)


def compiled_stdlib(core: Path, cache: Cache) -> Path:
    """Return the whole standard library as one archive of .pyc files."""

    def make(folder: Path) -> None:
        archive = {
            "from": str(core / pins.STDLIB), "to": str(folder / "stdlib.zip"),
            "optimize": NO_DOCSTRINGS, "wheel": False,
        }  # fmt: skip
        compile_archives(core, [archive], folder)

    key = key_of(tools_key(), code_key("stdlib"), pins.CORE[pins.STDLIB])
    return cache.step("stdlib", key, make) / "stdlib.zip"


def compile_archives(core: Path, archives: list[dict[str, object]], folder: Path) -> None:
    """Compile archives inside Pyodide: its Python alone has the right bytecode."""
    job = {"core": f"{core}/", "programs": [str(INSIDE / "compile_tree.py")], "archives": archives}
    run_script("compile.mjs", job, folder)


def used_files(
    core: Path, stdlib: Path, folder: Path, *,
    wheels: Iterable[Path], modules: Iterable[str] = (), perhaps: Iterable[str] = (),
    packages: Iterable[str] = (), absent: Iterable[str] = (),
    apart: Iterable[str] = (), entry: str = "",
) -> Used:  # fmt: skip
    """Import `modules` and all of `packages`, and return what that took.

    Of the modules in `perhaps`, those that Pyodide has are imported too. Modules that need a
    package in `absent` are left for later. `entry` is used once, if given.
    """
    out = folder / "used.json"
    job = {
        "core": f"{core}/", "stdlib": str(stdlib), "out": str(out), "entry": entry,
        "programs": [str(INSIDE / "used.py"), str(INSIDE / "warm.py")],
        "wheels": [str(w) for w in wheels], "modules": [*ALWAYS, *modules], "perhaps": [*perhaps],
        "packages": [*packages], "absent": [*absent], "apart": [*apart],
    }  # fmt: skip
    run_script("used.mjs", job, folder)
    found = json.loads(out.read_text(encoding="utf-8"))
    out.unlink()
    return Used(tuple(found["used"]), tuple(found["later"]))


def append_selection(stdlib: Path, names: Iterable[str], target: zipfile.ZipFile) -> None:
    """Append the files `names`, uncompressed: an archive is packed once, as a whole, later."""
    with zipfile.ZipFile(stdlib) as source:
        have = set(source.namelist())
        for name in sorted(set(names) & have):
            info = zipfile.ZipInfo(name, DATE)
            info.external_attr = 0o644 << 16
            info.create_system = 3
            target.writestr(info, source.read(name))
