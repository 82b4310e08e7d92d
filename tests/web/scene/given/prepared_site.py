"""Pages with prepared runs, for a browser without WebAssembly and for others."""

from __future__ import annotations

import html
from pathlib import Path

import pytest

from sim.pages.blocks.makers import Page as Making
from sim.pages.blocks.makers import made
from sim.pages.blocks.scene_block import Lesson
from sim.pages.text.fence_scan import scan
from tests.web.runtime.boot_site import ROOT, STRICT, bundle
from tests.web.scene.given.widget_site import PAGE, widget_site

__all__ = ["widget_site"]  # a fixture

SLIDES = """```scene
id: slides
carts:
  A: {mass: 1 kg, position: 0.3 m, velocity: 2 km/h}
  B: {mass: 1 kg, position: 1 m}
contact: {restitution: 0.8, stiffness: 300 N/m}
until: 4 s
controls:
  - {set: A.mass, from: 0.5 kg, to: 3 kg, step: 0.1 kg}
  - {set: A.velocity, from: 0.5 km/h, to: 5 km/h, step: 0.5 km/h}
presets: {quick: {A.velocity: 4.2 km/h}}
```"""
ASKS = SLIDES.replace("id: slides", "id: asks").replace(
    "presets: {quick: {A.velocity: 4.2 km/h}}", "predict: {choice: [It stops, It turns back]}"
)
RUBS = """```scene
id: rubs
carts:
  A: {mass: 1 kg, position: 0.3 m, velocity: 0.5 m/s}
until: 4 s
effects: [friction: {coefficient: 0.02}]
controls:
  - {set: A.mass, from: 0.5 kg, to: 3 kg, step: 0.1 kg}
  - switch: friction
```"""
AFTER = """<carts-after data-after="asks"><p>It turned back.</p></carts-after>
<script src="assets/carts/answers.js" defer></script>"""
FAILS = '<script src="no-python.js"></script>'


@pytest.fixture(scope="module")
def prepared_site(widget_site: Path) -> Path:
    """Pages as the generator makes them, for a browser without WebAssembly and for others."""
    folder = widget_site / "assets" / "carts" / "prepared"
    folder.mkdir(exist_ok=True)
    (widget_site / "no-python.js").write_text("delete window.WebAssembly;\n", encoding="utf-8")
    entry = ROOT / "sim" / "web" / "src" / "answers-main.js"
    bundle(entry, widget_site / "assets" / "carts" / "answers.js")
    for name, text in (("slides", SLIDES), ("asks", ASKS), ("rubs", RUBS)):
        (block,) = scan(text.splitlines(), front_matter=False)
        making = Making(Lesson(f"{name}.md"), prepares=True)
        body = made(block, making)
        for address, script in making.prepared.items():
            (folder / address).write_text(script, encoding="ascii")
        page = PAGE.format(csp=html.escape(STRICT), body=body)
        (widget_site / f"{name}.html").write_text(page, encoding="utf-8")
        page = page.replace("<title>", f"{FAILS}<title>")
        if name == "asks":
            page = page.replace("</main>", f"{AFTER}</main>")
        (widget_site / f"{name}-without.html").write_text(page, encoding="utf-8")
    return widget_site
