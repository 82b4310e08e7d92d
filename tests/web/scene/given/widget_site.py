"""Pages with one scene each, as the generator makes them, with the script made from its source."""

from __future__ import annotations

import html
import json
import shutil
import subprocess
from array import array
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page

from sim.bridge.protocol import answer
from sim.pages.runtime import default_cache, pack
from sim.pages.runtime.node import node_program
from sim.pages.widget import render
from sim.scene import Fence, read_fence
from tests.conftest import made_once
from tests.web.runtime.boot_site import ROOT, STRICT, bundle
from tests.web.site.pages_of import DRAWN

MEETING: dict[str, Any] = {
    "id": "meeting",
    "title": "A light cart meets a heavy one",
    "carts": {
        "A": {"mass": "0.5 kg", "position": "0.40 m", "velocity": "0.60 m/s"},
        "B": {"mass": "1.0 kg", "position": "1.30 m"},
    },
    "track": {"length": "2.4 m", "right": "wall"},
    "contact": {"restitution": "0.8", "stiffness": "400 N/m"},
    "until": "6 s",
    "controls": [
        {"set": "A.mass", "from": "0.5 kg", "to": "4 kg", "step": "0.1 kg"},
        {"set": "A.velocity", "from": "0.2 m/s", "to": "1 m/s", "step": "0.05 m/s"},
        {"set": "contact.restitution", "from": "0.1", "to": "1", "step": "0.05"},
    ],
}
PLAY: dict[str, Any] = {
    **MEETING,
    "id": "play",
    "presets": {"elastic": {"contact.restitution": 1}, "heavy hits light": {"A.mass": "4 kg"}},
    "controls": [
        *MEETING["controls"],
        {"set": "A.position", "from": "0.2 m", "to": "1 m", "step": "0.1 m"},
    ],
}
ARROWS = {**MEETING, "id": "arrows", "predict": {"arrows": ["A-B"], "scale": "newtons"}}
CURVE = {**MEETING, "id": "curve", "predict": {"curve": "F.A"}}
CHOICE = {
    **MEETING,
    "id": "choice",
    "predict": {"ask": "What does A do?", "choice": ["It stops", "It turns back"]},
}
WORDS = {**MEETING, "id": "words", "predict": {"text": "What does A do?"}}
QUESTIONS = {fence["id"]: fence for fence in (ARROWS, CURVE, CHOICE, WORDS)}
SPEED: dict[str, Any] = {
    "id": "speed",
    "carts": {"A": {"mass": "0.5 kg", "position": "0.40 m", "velocity": "0.50 m/s"}},
    "until": "2 s",
    "predict": {"curve": "v.A"},
}
COASTING: dict[str, Any] = {
    "id": "coasting",
    "title": "Seen from a moving camera",
    "carts": {"A": {"mass": "0.5 kg", "position": "0.40 m", "velocity": "0.50 m/s"}},
    "track": {"length": "1.2 m"},
    "until": "5 s",
    "view": "moving 0.3 m/s",
    "slow": "never",
    "forces": "hidden",
    "show": ["x", "v"],
}
STRUCK: dict[str, Any] = {
    "id": "struck",
    "carts": {
        "A": {"mass": 5, "position": 0.5, "velocity": 1},
        "B": {"mass": 1, "position": 1.5, "velocity": -1},
    },
    "track": {"length": 2},
    "contact": {"law": "instant", "restitution": "0.5"},
    "until": 3,
    "show": ["x", "v", "a", "F", "R", "p", "energy"],
}
GUESSED = {**STRUCK, "id": "guessed", "predict": {"choice": ["It stops", "It turns back"]}}
FENCES = {f["id"]: f for f in (MEETING, *QUESTIONS.values(), SPEED, COASTING, STRUCK, GUESSED)}

PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{csp}">
<meta name="carts-site" content="widget-tests">
<title>Scene</title><link rel="icon" href="data:,">
<link rel="stylesheet" href="assets/carts/carts.css">
<script src="assets/carts/carts.js" defer></script></head>
<body><main><p>Words before.</p>{body}<p id="below">Words after.</p></main></body></html>
"""


def baked(fence: dict[str, Any]) -> tuple[Fence, dict[str, Any], array[float]]:
    """A fence, and header and numbers of its run."""
    described = read_fence(fence)
    header, numbers = answer({"id": 0, "kind": "run", "scene": dict(described.plain)})
    assert header["ok"], header
    return described, header, numbers


def write_page(site: Path, name: str, *fences: dict[str, Any]) -> Path:
    """Write a page with these scenes under the strict policy."""
    body = "".join(render(*baked(fence)) for fence in fences)
    page = site / f"{name}.html"
    page.write_text(PAGE.format(csp=html.escape(STRICT), body=body), encoding="utf-8")
    return page


def build_site(site: Path) -> Path:
    """A site with a page per scene and the real runtime."""
    (site / "assets" / "carts").mkdir(parents=True)
    pack(site, packages=frozenset(), cache=default_cache(ROOT), report=lambda _: None)
    shutil.copy(ROOT / "sim" / "web" / "css" / "carts.css", site / "assets" / "carts")
    bundle(ROOT / "sim" / "web" / "src" / "main.js", site / "assets" / "carts" / "carts.js")
    for name, fence in FENCES.items():
        write_page(site, name, fence)
    return site


def in_node(script: str, data: object) -> Any:
    """The value that a module script gives to `give(value)`; `data` is what it works on."""
    source = (ROOT / "sim" / "web" / "src").as_uri()
    head = (
        'import { readFileSync } from "node:fs";\n'
        'const data = JSON.parse(readFileSync(0, "utf8"));\n'
        f"const source = {json.dumps(source)};\n"
        f"const view = {json.dumps((ROOT / 'sim' / 'view').as_uri())};\n"
        # what only waits (a page's patience, five seconds of it) is not waited for once all is told
        # (all inside of `give`: a script may call its own things as it likes)
        "const give = (() => {\n"
        "  const [later, waiting] = [globalThis.setTimeout, []];\n"
        "  globalThis.setTimeout = (...given) => waiting[waiting.push(later(...given)) - 1];\n"
        "  return (value) => {\n"
        "    process.stdout.write(JSON.stringify(value));\n"
        "    for (const one of waiting) one.unref();\n"
        "  };\n"
        "})();\n"
    )
    done = subprocess.run(
        [str(node_program()), "--input-type=module", "-e", head + script],
        input=json.dumps(data), capture_output=True, text=True, check=False, timeout=60, cwd=ROOT,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


AT_REST = """el => new Promise((done) => {
  let waiting = 0;
  const wait = () => {
    clearTimeout(waiting);
    waiting = setTimeout(() => { watching.disconnect(); done(); }, 400);
  };
  const watching = new MutationObserver(wait);
  watching.observe(el, { subtree: true, childList: true, attributes: true, characterData: true });
  wait();
})"""
"""Until nothing has changed in an element for longer than any of its timers waits."""

PLAYS = "() => document.getElementById('meeting').time > 0.1"
"""Its clock goes on."""

LIVE = 20_000  # ms; a loaded machine in the tests, not the goal


@pytest.fixture(scope="session")
def widget_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Every file of tests that imports this has a copy of its own, to write into; the site itself
    is built once for all workers."""
    built = made_once(tmp_path_factory, "widgets", build_site)
    return shutil.copytree(built, tmp_path_factory.mktemp("widget") / "site")


def in_windows(page: Page, widths: Iterable[int], height: int) -> Iterator[int]:
    """The page in windows that are pulled to one width after the other, each laid out."""
    for width in widths:
        page.set_viewport_size({"width": width, "height": height})
        page.evaluate(DRAWN)
        yield width


def lock(page: Page, name: str) -> None:
    """Lock the prediction and go straight to the end of the run that it brings."""
    if (sure := page.locator(f"#{name} .carts-certainty input")).count():
        sure.first.check()
    page.locator(f"#{name} .carts-lock").click()
    page.locator(f"#{name} .carts-end:enabled").click(timeout=LIVE)


def live(page: Page, name: str = "meeting") -> Page:
    page.wait_for_selector(f'#{name}[data-state="live"]', timeout=LIVE)
    return page


def on_scene(page: Page, script: str, argument: Any = None, name: str = "meeting") -> Any:
    """The value of a function body that has the element as `el`."""
    return page.locator(f"#{name}").evaluate(
        f"async (el, argument) => {{ {script} }}", argument, timeout=LIVE
    )
