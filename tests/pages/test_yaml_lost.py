"""What YAML would take out of a text without a word is named where it stands."""

from __future__ import annotations

import re

import pytest

from sim.pages.text.yaml_source import YamlError, load

FORMULAS = r"""
\frac{1}{2} \vec F \nabla \theta \times \tau \rho \beta \bar x \alpha \nu \epsilon \Lambda \Phi \Pi
\_ \0 \xi \upsilon \Upsilon \neq \ne \not \mu
"""


@pytest.mark.parametrize("formula", re.findall(r"(?<= |\n)\\\w+", FORMULAS))
@pytest.mark.parametrize(
    "where", ['ask: "What is ${} m$?"', 'a: [b, "What is ${}$?"]', '"${}$": 1']
)
def test_a_formula_in_double_quotes_is_not_turned_into_something_else(
    formula: str, where: str
) -> None:
    text = where.replace("{}", formula)
    with pytest.raises(YamlError) as caught:
        load(f"id: q\n{text}\nexplain: no")
    assert (caught.value.line, caught.value.col) == (2, text.index("\\") + 1)
    assert caught.value.message == "a backslash means something else in double quotes"
    assert "single quotes" in caught.value.hint


@pytest.mark.parametrize("text", [r'a: "x \x07"', r'a: "x \u0000"'])
def test_a_character_that_no_page_can_show_is_refused_however_it_is_written(text: str) -> None:
    with pytest.raises(YamlError):
        load(text)


@pytest.mark.parametrize(
    ("written", "read"),
    [
        (r'"one\ntwo \n three \nnote"', "one\ntwo \n three \nnote"),
        (r'"\\frac \" \u00e9 \xe9 \/ a\ b"', '\\frac " é é / a b'),
        (r"'\frac{1}{2} \nu'", r"\frac{1}{2} \nu"),
        (r"\frac{1}{2} \nu", r"\frac{1}{2} \nu"),
    ],
)
def test_an_escape_that_can_be_meant_is_read(written: str, read: str) -> None:
    assert load(f"key: {written}\n").plain["key"] == read


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("hints: Look at graph #2", (1, 22)),
        ("options:\n  - Cart #2 pushes\n  - Neither", (2, 10)),
        ("pairs:\n  - {left: a cart,\n     right: cart #1\n    }", (3, 18)),
        ("pairs:\n  - {left: cart #1, right: b}", (2, 17)),
        ("rubric:\n  1: names cart #1", (2, 17)),
        ("ask: What does\n  cart #1 do?", (2, 8)),
        ("note: What does\n  cart #1 do\n  to it?", (2, 8)),
        ("a: [cart #1, b]", (1, 10)),
        ("a: #1", (1, 4)),
        ("a: x   ##1", (1, 8)),
    ],
)
def test_a_text_that_a_sign_for_numbers_cuts_off_is_named_where_it_is_cut(
    text: str, place: tuple[int, int]
) -> None:
    with pytest.raises(YamlError) as caught:
        load(text)
    assert (caught.value.line, caught.value.col) == place
    assert caught.value.message == "what comes after # is left out"
