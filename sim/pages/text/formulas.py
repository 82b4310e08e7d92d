"""Formulas of a page, drawn by KaTeX when the site is built: no script draws them for a reader.

KaTeX writes sizes as style attributes, which the policy of the pages forbids. Each becomes a class,
named by what it says, in one style sheet for the whole site.
"""

from __future__ import annotations

import hashlib
import html
import re
from dataclasses import dataclass, field
from pathlib import Path

from sim.pages.drawing import draw_formula

SHEET = "katex/sizes.css"
KATEX = "katex/dist/katex.min.js"
_FORMULA = re.compile(r'(<(span|div) class="arithmatex">)(.*?)(</\2>)', re.DOTALL)
_DELIMITERS = re.compile(r"\s*\\([(\[])(?P<tex>.*)\\[)\]]\s*", re.DOTALL)
_STYLED = re.compile(r'<(?P<tag>\w+)(?P<others>[^<>]*?) style="(?P<style>[^"]*)"(?P<after>[^<>]*)>')
_CLASS = re.compile(r' class="([^"]*)"')


@dataclass(slots=True)
class Formulas:
    """Draws the formulas of pages, and knows what their style sheet must hold."""

    modules: Path  # what npm installed
    sizes: dict[str, str] = field(default_factory=dict)  # declarations, by the name of their class

    def drawn(self, page: str) -> str:
        """The page with its formulas drawn; a mistake in one is shown in red in its place."""
        return _FORMULA.sub(self._one, page)

    def write(self, assets: Path) -> None:
        """The style sheet of all pages drawn so far, if any; it wins as a style attribute does."""
        rules = []
        for name, style in sorted(self.sizes.items()):
            each = (f"{one.strip()} !important" for one in style.split(";") if one.strip())
            rules.append(f".{name} {{ {'; '.join(each)} }}\n")
        if rules:
            (assets / SHEET).write_text("".join(rules), encoding="ascii")

    def _one(self, found: re.Match[str]) -> str:
        written = _DELIMITERS.fullmatch(html.unescape(found[3]))
        if not written:
            return found[0]
        drawn = draw_formula(written["tex"], display=written[1] == "[", katex=self.modules / KATEX)
        return found[1] + _STYLED.sub(self._without_style, drawn) + found[4]

    def _without_style(self, tag: re.Match[str]) -> str:
        style = html.unescape(tag["style"])
        name = f"kx-{hashlib.sha256(style.encode()).hexdigest()[:8]}"
        self.sizes[name] = style
        others = tag["others"] + tag["after"]
        if own := _CLASS.search(others):
            others = f'{others[: own.start()]} class="{own[1]} {name}"{others[own.end() :]}'
        else:
            others = f'{others} class="{name}"'
        return f"<{tag['tag']}{others}>"
