"""What finds pale text and breaches of accessibility in a page: our contrast, and axe-core."""

from __future__ import annotations

from pathlib import Path

PALE = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
# Contrast is ours to find, in all views (`contrast.js`); axe looks for it on one page of each kind,
# and there at what surrounds the text too: head and navigation are the same on all pages.
RUN_AXE = """(whole) => axe.run(whole ? document : "article", { resultTypes: ["violations"],
    rules: { "color-contrast": { enabled: whole } } })
  .then(({ violations }) => violations.map(({ id, nodes }) =>
    [id, ...nodes.slice(0, 3).map(({ target }) => target.join(" "))]))"""
