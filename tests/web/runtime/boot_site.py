"""Builds the least site that runs Python, under the same strict policy as every page of ours."""

from __future__ import annotations

import functools
import html
import json
import os
import subprocess
import tempfile
from pathlib import Path

from sim.pages.runtime import default_cache, pack
from sim.pages.runtime.node import node_program

ROOT = Path(__file__).parents[3]
STRICT = (
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; "
    "connect-src 'none'; style-src 'self'; img-src 'self' data:; font-src 'self'; "
    "base-uri 'none'; form-action 'none'"
)
SCENE = {"carts": {"A": {"mass": 0.5, "velocity": 0.6, "position": 0.4}}, "until": 2}
RUN = {"id": 7, "kind": "run", "scene": SCENE}

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{csp}">
<title>Boot</title><link rel="icon" href="data:,">{before}
<script src="assets/carts/boot.js" defer></script></head>
<body data-packages="{packages}" data-request="{request}">Boot</body></html>
"""

# Answers like the bridge, and imports what it is told to.
STAND_IN = '''"""Answers with what was asked for: an import, an endless loop, or a random number."""

import importlib
import json
import random
from array import array


told = []


def listen(call):
    told.append(call)


def answer(text):
    from js import Array, Float64Array

    request = json.loads(text)
    header = {"id": request.get("id"), "ok": True, "random": random.random()}
    if "import" in request:
        names = request["import"]
        header["versions"] = [getattr(importlib.import_module(n), "__version__", "") for n in names]
    if "run" in request:
        header["result"] = eval(request["run"])
    return Array.of(json.dumps(header), Float64Array.new(2))
'''


def bundle(entry: Path, out: Path) -> None:
    """Bundle a page's script as `make bundle` does."""
    out.write_bytes(_bundled(entry))


@functools.cache
def _bundled(entry: Path) -> bytes:
    """Made once by every worker: most sites of the tests have the same few scripts."""
    here = ROOT / "sim" / "web"
    command = [str(node_program()), str(here / "bundle.mjs"), os.path.relpath(entry, here)]
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "out.js"
        subprocess.run([*command, str(out)], check=True, cwd=ROOT)
        return out.read_bytes()


def write_page(
    site: Path, *, name: str = "index.html", csp: str = STRICT, packages: str = "",
    request: object = None, before: str = "",
) -> Path:  # fmt: skip
    """Write a page that starts Python, sends `request` and remembers what came."""
    site.mkdir(parents=True, exist_ok=True)
    text = PAGE.format(
        csp=html.escape(csp), packages=packages, before=before,
        request=html.escape(json.dumps(RUN if request is None else request)),
    )  # fmt: skip
    (site / name).write_text(text, encoding="utf-8")
    return site / name


def build_site(
    site: Path, *, packages: frozenset[str] = frozenset(), source: Path | None = None
) -> Path:
    """Build a site with the real runtime, or with the package in folder `source`."""
    extra = {"source": source} if source else {}
    pack(site, packages=packages, cache=default_cache(ROOT), report=lambda _: None, **extra)
    bundle(
        ROOT / "tests" / "web" / "runtime" / "boot_page.js", site / "assets" / "carts" / "boot.js"
    )
    write_page(site)
    return site


def write_stand_in(folder: Path) -> Path:
    """Write a package `sim` that answers anything and return its folder."""
    for layer in ("", "scene", "bridge"):
        (folder / "sim" / layer).mkdir(parents=True, exist_ok=True)
        (folder / "sim" / layer / "__init__.py").write_text('"""Stand-in."""\n', encoding="utf-8")
    (folder / "sim" / "bridge" / "pyodide_entry.py").write_text(STAND_IN, encoding="utf-8")
    return folder / "sim"
