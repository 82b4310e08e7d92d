"""What finds pale text and breaches of accessibility in a page: our contrast, and axe-core."""

from __future__ import annotations

from pathlib import Path

PALE = (Path(__file__).parent / "contrast.js").read_text(encoding="utf-8")
# What is pressed or pulled, smaller than a pointer that trembles can hit (WCAG 2.2, 2.5.8). A box
# with words beside it is as large as both; links in a text, and the theme's, are not looked at.
SMALL = """(least) => [...document.querySelectorAll(
    "article :is(button, select, input, textarea, label:has([type=radio], [type=checkbox])),"
    + ".carts-bar button")]
  .filter((one) => one.closest(".carts, .carts-bar") && one.checkVisibility()
    && !(one.matches("[type=radio], [type=checkbox]") && one.closest("label")))
  .map((one) => [one, one.getBoundingClientRect()])
  .filter(([, { width, height }]) => width > 1 && Math.min(width, height) < least - 0.01)
  .map(([one, { width, height }]) =>
    `${one.localName}.${one.className} ${one.textContent.trim()}: ${width} × ${height}`)
"""
# Contrast is ours to find, in all views (`contrast.js`); axe looks for it on one page of each kind,
# and there at what surrounds the text too: head and navigation are the same on all pages. So it is
# for links in a text, told from it by their colour: that alone takes axe a third of its time. No
# rule here reads style sheets, which axe else loads first.
RUN_AXE = """(whole) => axe.run(whole ? document : {
    include: [document.querySelector("article") ?? document.body],
    exclude: [...new Set([...document.querySelectorAll("article *")].map((one) => one.localName))]
      .filter((name) => name.startsWith("carts-")) }, { resultTypes: ["violations"],
    preload: false, rules: { "color-contrast": { enabled: whole },
      "link-in-text-block": { enabled: whole } } })
  .then(({ violations }) => violations.map(({ id, nodes }) =>
    [id, ...nodes.slice(0, 3).map(({ target }) => target.join(" "))]))"""
