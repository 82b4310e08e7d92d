"""A page on which a law is written, made by the generator's own parts."""

from __future__ import annotations

import html
from pathlib import Path

from sim.pages.blocks.bake import OWN_LAW
from sim.pages.blocks.extension import Page
from sim.pages.blocks.makers import made
from sim.pages.blocks.scene_block import Lesson
from sim.pages.runtime import default_cache, pack
from sim.pages.templates import script_json
from sim.pages.text.fence_scan import scan
from tests.web.runtime.boot_site import ROOT, STRICT, bundle

PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{csp}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="carts-site" content="test-site"><meta name="carts-page" content="law">
<title>A law</title><link rel="icon" href="data:,">
<link rel="stylesheet" href="assets/carts/carts.css"></head>
<body><main><h1>A law</h1>{element}</main>
<script src="assets/carts/law.js"></script>
<script type="application/json" id="carts-lesson">{outline}</script>
<script src="assets/carts/answers.js"></script></body></html>
"""
BODY = """\
id: my-law
ask: Let the heavier one push harder.
start: |
  def force(overlap, rate):
      return 100 * overlap
carts:
  A: {mass: 2.0 kg, position: 0.40 m, velocity: 0.40 m/s}
  B: {mass: 0.5 kg, position: 1.20 m}
until: 3 s
"""


def element(body: str = BODY) -> tuple[str, Page]:
    """The element of a block with this body, and the page that it stands on."""
    (block,) = scan(f"```law\n{body}```".splitlines())
    page = Page(Lesson("lesson.md"))
    return made(block, page), page


def build_law(site: Path, body: str = BODY) -> Path:
    """Write law.html with this block into `site`, with the runtime that it needs."""
    assets = site / "assets" / "carts"
    assets.mkdir(parents=True)
    pack(site, packages=frozenset({OWN_LAW}), cache=default_cache(ROOT), report=lambda _: None)
    web = ROOT / "sim" / "web"
    (assets / "carts.css").write_bytes((web / "css" / "carts.css").read_bytes())
    for name in ("law", "answers"):
        bundle(web / "src" / f"{name}-main.js", assets / f"{name}.js")
    content, page = element(body)
    outline = script_json(page.items.outline("law"))
    text = PAGE.format(csp=html.escape(STRICT), element=content, outline=outline)
    (site / "law.html").write_text(text, encoding="utf-8")
    return site
