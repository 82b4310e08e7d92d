"""Formulas are drawn when the site is built, without a style attribute: the policy forbids it."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

from sim.pages.text.formulas import SHEET, Formulas
from tests.conftest import ROOT

PAGE = """<p>Force <span class="arithmatex">\\(F = m\\,\\dfrac{\\Delta v}{\\Delta t}\\)</span></p>
<div class="arithmatex">\\[
\\sqrt{\\mathbf{k}/\\mu} &lt; \\left(\\tfrac12\\right)^2
\\]</div>"""

MATH = "{http://www.w3.org/1998/Math/MathML}"
PARTS = {"mfrac": 2, "msub": 2, "msup": 2, "mover": 2, "munder": 2, "msubsup": 3, "munderover": 3}


@pytest.fixture
def formulas() -> Formulas:
    return Formulas(ROOT / "node_modules")


def test_every_formula_is_drawn_and_spoken(formulas: Formulas) -> None:
    drawn = formulas.drawn(PAGE)
    assert drawn.count('class="katex-html"') == drawn.count("<math ") == 2
    assert drawn.count('class="katex-display"') == 1
    assert "\\(" not in drawn and "\\[" not in drawn


def test_what_katex_says_in_style_attributes_is_said_in_the_style_sheet(
    formulas: Formulas, tmp_path: Path
) -> None:
    drawn = formulas.drawn(PAGE)
    assert ' style="' not in drawn
    (tmp_path / SHEET).parent.mkdir()
    formulas.write(tmp_path)
    sheet = (tmp_path / SHEET).read_text(encoding="ascii")
    used = set(re.findall(r"\bkx-[0-9a-f]{8}\b", drawn))
    assert used == set(re.findall(r"^\.(kx-[0-9a-f]{8}) \{ .+ !important \}$", sheet, re.MULTILINE))
    assert "border-bottom-width:0.04em !important" in sheet  # of the fraction


def test_a_mistake_in_a_formula_is_shown_in_its_place(formulas: Formulas) -> None:
    drawn = formulas.drawn(r'<span class="arithmatex">\(\fracc{1}\)</span> and text')
    assert "katex-error" in drawn or "fracc" in drawn
    assert drawn.endswith("</span> and text")
    assert ' style="' not in drawn


def test_a_page_without_a_formula_stays_as_it_is(formulas: Formulas, tmp_path: Path) -> None:
    assert formulas.drawn("<p>5 &lt; 6</p>") == "<p>5 &lt; 6</p>"
    formulas.write(tmp_path)
    assert not (tmp_path / SHEET).exists()


@pytest.mark.slow
def test_every_formula_of_the_site_has_all_its_parts(site: Path) -> None:
    """As MathML Core asks for; a browser draws a fraction without its lower half as a row."""
    found = [
        (page.name, part.tag, len(part))
        for page in site.rglob("*.html")
        for formula in re.findall(r"<math[ >].*?</math>", page.read_text("utf-8"), re.DOTALL)
        for part in ElementTree.fromstring(formula).iter()
        if part.tag.removeprefix(MATH) in PARTS
    ]
    assert (f"{MATH}mfrac", 2) in {(tag, parts) for _, tag, parts in found}
    assert [one for one in found if one[2] != PARTS[one[1].removeprefix(MATH)]] == []
