"""The lock file of the page: what `loadPackage` may load, with the sha256 of each wheel.

Our wheels are packed again, so Pyodide's own lock file does not fit them; `pyodide lockfile
add-wheels` writes one that does. It comes with pyodide-build, which needs Python 3.12.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

from .cache import Cache, key_of, sha256
from .node import RuntimePackError, code_key

Lock = dict[str, object]  # pyodide-lock.json, as plain values
MADE = "lock.json"
TOOLS = ("pyodide-cli", "pyodide-lock", "pkginfo")

# What a wheel offers for import. The tool looks for .py files, and there are none left.
IMPORTS = {
    "newtons-carts": ["sim"],
    "newtons-carts-rest": ["sim"],
    "newtons-carts-class": ["sim.classroom"],
    "newtons-carts-teacher": ["sim.pages"],
    "newtons-carts-measured": ["sim.measured"],
    "newtons-carts-worlds": ["sim.worlds"],
    "newtons-carts-law": ["sim.mine"],
    "newtons-carts-proof": ["sim.certify"],
    "numpy": ["numpy"],
    "scipy": ["scipy"],
}


def tool_works() -> bool:
    """Whether `pyodide lockfile add-wheels` is there and can read our wheels."""
    return sys.version_info >= (3, 12) and all(find_spec(t.replace("-", "_")) for t in TOOLS)


def make_lock(release: Path, wheels: Mapping[str, Path], cache: Cache) -> Lock:
    """Return the lock for `wheels` (package -> file). `release` is Pyodide's own lock file."""
    if not tool_works():
        return release_lock(release, wheels)

    def make(folder: Path) -> None:
        with cache.workspace() as work:
            copies = [work / path.name for path in wheels.values()]
            for copy, path in zip(copies, wheels.values(), strict=True):
                copy.write_bytes(path.read_bytes())
            lock = add_wheels(release, copies, work)
        (folder / MADE).write_text(json.dumps(lock), encoding="utf-8")

    # Of each set of packages the last few are kept: a site has one, the tests of ours have many.
    name = f"lock.{key_of(*sorted(wheels))[:8]}"
    held = (part for path in wheels.values() for part in (path.name, sha256(path.read_bytes())))
    tools = (version(tool) for tool in TOOLS)
    key = key_of(code_key("lock"), *tools, sha256(release.read_bytes()), *held)
    made: Lock = json.loads((cache.step(name, key, make) / MADE).read_text(encoding="utf-8"))
    return made


def add_wheels(release: Path, wheels: list[Path], folder: Path) -> Lock:
    """Return a lock with just `wheels`, which lie in `folder`. `release` is Pyodide's lock file.

    The tool expects wheels to be tagged by the platform of Emscripten, while today's are tagged by
    the version of Pyodide's ABI: it is shown that tag as the platform.
    """
    info = json.loads(release.read_text(encoding="utf-8"))["info"]
    shown = {"info": {**info, "platform": f"pyemscripten_{info['abi_version']}"}, "packages": {}}
    source, target = folder / "lock-before.json", folder / "lock-after.json"
    source.write_text(json.dumps(shown), encoding="utf-8")
    command = [sys.executable, "-m", "pyodide_cli", "lockfile", "add-wheels"]
    command += ["--input", str(source), "--output", str(target), "--base-path", str(folder)]
    done = subprocess.run(
        [*command, *map(str, wheels)], capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise RuntimePackError(f"pyodide lockfile add-wheels failed:\n{done.stderr[-2000:]}")
    packages = json.loads(target.read_text(encoding="utf-8"))["packages"]
    for path in (source, target):
        path.unlink()
    return _lock(info, packages)


def release_lock(release: Path, wheels: Mapping[str, Path]) -> Lock:
    """Return the release's own entries, which fit its unchanged wheels, and one for our wheel."""
    before = json.loads(release.read_text(encoding="utf-8"))
    entries = {name: before["packages"][name] for name in wheels if name in before["packages"]}
    for name in set(wheels) - set(entries):
        path = wheels[name]
        entries[name] = {
            "name": name, "version": path.name.split("-")[1], "file_name": path.name,
            "install_dir": "site", "sha256": sha256(path.read_bytes()), "package_type": "package",
            "imports": IMPORTS[name], "depends": [], "unvendored_tests": False,
        }  # fmt: skip
    return _lock(before["info"], entries)


def _lock(info: object, packages: Mapping[str, dict[str, object]]) -> Lock:
    return {
        "info": info,
        "packages": {n: {**p, "imports": IMPORTS[n]} for n, p in sorted(packages.items())},
    }
