"""Formulas of QTI items as MathML, which players draw; KaTeX makes it of what an author typed."""

from __future__ import annotations

import re
from collections.abc import Callable
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

from sim.pages.drawing import DrawingError, draw_formula

Formulas = Callable[[str, bool], str | None]
"""The MathML of a formula in TeX, on lines of its own or not; None: it cannot be had."""

FORMULA = re.compile(
    r'<(span|div)(?: class="arithmatex")?>\\(?P<how>[(\[])(?P<tex>.*?)\\[)\]]</\1>', re.DOTALL
)
_MATH = re.compile(r"(<math\b[^>]*>)<semantics>(.*)<annotation\b.*</math>", re.DOTALL)


def no_formulas(_tex: str, _display: bool) -> None:
    """For texts that keep their TeX."""


def formulas_by(katex: Path) -> Formulas:
    """Formulas as the script of KaTeX at `katex` reads them."""

    def made(tex: str, display: bool) -> str | None:
        try:
            found = _MATH.search(draw_formula(tex, display=display, katex=katex))
            math = f"{found[1]}{found[2]}</math>" if found else None  # none: a mistake in the TeX
            if math:
                ElementTree.fromstring(math)
        except (DrawingError, OSError, ElementTree.ParseError):
            return None
        return math

    return made


def with_mathml(markup: str, formulas: Formulas) -> str:
    """An item, or a text of a question, with the formulas drawn that can be had."""

    def shown(found: re.Match[str]) -> str:
        math = formulas(unescape(found["tex"]), found["how"] == "[")
        return f"<{found[1]}>{math}</{found[1]}>" if math else found[0]

    return FORMULA.sub(shown, markup)
