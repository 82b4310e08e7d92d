"""What a site's runtime folder holds: every file as scripts, and the index that names them."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from . import pins
from .cache import Cache, key_of, sha256
from .classic import classic_script
from .extra_wheel import make_extra_wheel
from .lock import make_lock
from .node import code_key, node_version
from .ours import ENTRY, NAME, Ours
from .packages import MORE, make_packages, more_of_stdlib
from .payload import Payload, payload_from_json, write_payload
from .rest_wheel import REST, make_rest_wheel
from .snapshot import make_start
from .stdlib import compiled_stdlib

Report = Callable[[str], None]

LOADER = "pyodide.js"
STDLIB = "python.zip"
SNAPSHOT = "memory.snapshot"


@dataclass(frozen=True)
class Contents:
    """Scripts by file name, the index without its envelope, versions by component."""

    scripts: dict[str, Path]
    index: dict[str, object]
    versions: dict[str, str]


def make_contents(
    core: Path,
    ours: Ours,
    originals: dict[str, Path],
    cache: Cache,
    report: Report,
    extras: Iterable[Ours] = (),
) -> Contents:
    """Return the runtime with `ours` and the wheels `originals` (package name -> verified file).

    `extras`: packages of ours that few pages load, where the site has such pages.
    """
    report("Packing Python for the page")
    stdlib = compiled_stdlib(core, cache)
    start = make_start(core, stdlib, ours, cache)
    files = {
        LOADER: _loader(core),
        pins.WASM: (core / pins.WASM).read_bytes(),
        SNAPSHOT: start.snapshot.read_bytes(),
        STDLIB: start.stdlib.read_bytes(),
    }
    wheels = {NAME: start.wheel}
    if start.used.later:
        wheels[REST] = make_rest_wheel(start.wheel, start.used.later, ours, cache)
    more: list[str] = []
    if originals:
        packages = make_packages(originals, core, stdlib, cache, report)
        wheels |= packages.wheels
        more += packages.used
    ours_too = {NAME, REST}
    for extra in extras:
        ours_too.add(extra.name)
        made = make_extra_wheel(core, stdlib, start.wheel, extra, cache)
        wheels[extra.name] = made.wheel
        more += made.used
    table_at = 0
    if more:
        table_at, files[MORE] = more_of_stdlib(stdlib, more, start.stdlib)
    files |= {path.name: path.read_bytes() for path in wheels.values()}
    payloads = [_scripts(name, data, cache) for name, data in files.items()]
    lock = make_lock(core / pins.LOCK, wheels, cache)
    info = lock["info"]
    python = str(info["python"]) if isinstance(info, dict) else ""
    versions = {"pyodide": pins.PYODIDE, "python": python, "node": node_version()}
    index: dict[str, object] = {
        **versions,
        "entry": ENTRY,
        "package": NAME,
        "rest": REST,
        "later": list(start.used.later),
        "tableAt": table_at,
        "files": {payload.name: payload.as_json() for _, payload in payloads},
        "wheels": {name: path.name for name, path in wheels.items()},
        "lock": lock,
    }
    scripts = {part.src: folder / part.src for folder, p in payloads for part in p.parts}
    versions |= {n: path.name.split("-")[1] for n, path in wheels.items() if n not in ours_too}
    return Contents(scripts, index, versions)


def _loader(core: Path) -> bytes:
    loader, module = ((core / n).read_text(encoding="utf-8") for n in (pins.LOADER, pins.MODULE))
    return classic_script(loader, module, pins.PYODIDE).encode()


def _scripts(name: str, data: bytes, cache: Cache) -> tuple[Path, Payload]:
    """Return one file as scripts, packed again only when its bytes have changed."""

    def make(folder: Path) -> None:
        payload = write_payload(name, data, folder)
        (folder / "payload.json").write_text(json.dumps(payload.as_json()), encoding="utf-8")

    folder = cache.step(f"scripts-{name}", key_of(code_key("payload"), name, sha256(data)), make)
    return folder, payload_from_json(name, json.loads((folder / "payload.json").read_text()))
