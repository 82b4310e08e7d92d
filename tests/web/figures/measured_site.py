"""Two pages with readings of real carts, under the strict policy of every page of ours."""

from __future__ import annotations

import html
from pathlib import Path

from sim.pages.blocks.scene_block import Lesson, SiteIds
from sim.pages.measured.block import read_measured_block
from sim.pages.measured.render import render_measured
from sim.pages.runtime import MEASURED, default_cache, pack
from sim.pages.text.fence_scan import scan
from tests.web.runtime.boot_site import ROOT, STRICT, bundle

PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{csp}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="carts-site" content="test-site"><meta name="carts-page" content="bench">
<title>Real carts</title><link rel="icon" href="data:,">
<link rel="stylesheet" href="assets/carts/carts.css"></head>
<body><main><h1>Real carts</h1>{element}</main>
<script src="assets/carts/measured.js"></script></body></html>
"""
BLOCKS = {
    "film": "id: film\ndata: real-carts.txt\nunits: {length: m, time: s}",
    "forces": "id: forces\ndata: real-carts-forces.csv\nsynthetic: true",
    "empty": "id: empty\ntitle: Our own carts",
}


def element(body: str) -> str:
    """The element of a block with this body; its data lie beside the lessons."""
    (block,) = scan(f"```measured\n{body}\n```".splitlines())
    lesson = Lesson("lesson.md", (ROOT / "worksheets",))
    return render_measured(read_measured_block(block, lesson, SiteIds(), first_line=1))


def build_measured(site: Path) -> Path:
    """Write the pages film.html, forces.html and empty.html, alike but for their one block."""
    assets = site / "assets" / "carts"
    assets.mkdir(parents=True)
    packages = frozenset({"numpy", "scipy", MEASURED})
    pack(site, packages=packages, cache=default_cache(ROOT), report=lambda _: None)
    web = ROOT / "sim" / "web"
    sheets = [web / "css" / "carts.css", web / "css" / "measured.css"]
    (assets / "carts.css").write_bytes(b"\n".join(sheet.read_bytes() for sheet in sheets))
    bundle(web / "src" / "measured-main.js", assets / "measured.js")
    bundle(web / "src" / "film-main.js", assets / "film.js")
    for name, body in BLOCKS.items():
        text = PAGE.format(csp=html.escape(STRICT), element=element(body))
        (site / f"{name}.html").write_text(text, encoding="utf-8")
    return site
