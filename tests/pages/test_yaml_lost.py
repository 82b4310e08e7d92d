"""What YAML would take out of a text without a word is named where it stands."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

import pytest

from sim.pages.text.yaml.lost import PROSE_KEYS
from sim.pages.text.yaml.source import YamlError, load
from sim.pages.translate.block_units import schema_of
from sim.scene.prose import MARK

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
        ("intro: Look at graph #2", (1, 22)),
        ("accept: [zero]\nleft: cart #1", (2, 12)),
        ("options:\n  - Cart #2 pushes\n  - Neither", (2, 10)),
        ("pairs:\n  - {left: a cart,\n     right: cart #1\n    }", (3, 18)),
        ("pairs:\n  - {left: cart #1, right: b}", (2, 17)),
        ("rubric:\n  1: names cart #1", (2, 17)),
        ("ask: What does\n  cart #1 do?", (2, 8)),
        ("note: What does\n  cart #1 do\n  to it?", (2, 8)),
        ("words: [cart #1, b]", (1, 14)),
        ("left: x   ##1", (1, 11)),
        ("presets:\n  - a: {text: cart #1}", (2, 20)),
        ("options:\n- Cart #2\n  pushes\n- b", (2, 8)),
        ("rubric:\n  0: nothing\n  1: 2 carts #1", (3, 14)),
    ],
)
def test_a_text_that_a_sign_for_numbers_cuts_off_is_named_where_it_is_cut(
    text: str, place: tuple[int, int]
) -> None:
    with pytest.raises(YamlError) as caught:
        load(text)
    assert (caught.value.line, caught.value.col) == place
    assert caught.value.message == "what comes after # is left out"


@pytest.mark.parametrize(
    "text",
    [
        "mass: 0.5 kg #heavy",
        "correct: true #yes",
        "marks: 2 #two",
        "until: 3 s #long enough",
        "type: single #one right",
        "id: q-1 #first",
        "effects: #none yet",
        "accept: 2 N #exactly",
        "options:\n  - {\n    id: a #first\n    }\n  - 5 m/s² #fast",
        "rubric:\n  0: #nothing\n  1: 1 #one",
        "carts:\n  A: left #where it begins",
    ],
)
def test_a_remark_behind_what_is_no_free_text_loses_nothing(text: str) -> None:
    assert load(text).plain == load(re.sub(r" #.*", "", text)).plain


def _prose(schema: object, name: str) -> Iterator[str]:
    for one in schema if isinstance(schema, (list, tuple)) else [schema]:
        if isinstance(one, Mapping):
            yield from [name] if one.get(MARK) is True else []
            for key, value in one.items():
                if key == "properties":
                    for own, below in value.items():
                        yield from _prose(below, own)
                elif key == "patternProperties":
                    yield from _prose(list(value.values()), name)
                elif key in ("anyOf", "items", "additionalProperties"):
                    yield from _prose(value, name)


def test_free_text_is_what_the_schemas_mark_as_read() -> None:
    kinds = ("top", "question", "bank", "quiz", "scene", "challenge", "measured", "law")
    assert {name for kind in kinds for name in _prose(schema_of(kind), "")} == PROSE_KEYS


@pytest.mark.parametrize(
    ("text", "place", "said"),
    [
        ("# carts #1 and #2\na: b: c", (2, 5), "a colon where none is expected"),
        (
            "ask: |\n  What does cart #1 do?\n accept: zero",
            (3, 2),
            "this line is not indented like its neighbours",
        ),
        ("hints: b: c #x", (1, 9), "a colon where none is expected"),
        ("mass: 2 kg #heavy\n   position: 0.4 m", (2, 4), "this line is not indented"),
        ("id: q-1 #first\n  position", (2, 3), "this line is not indented"),
        ("words: [a,\n  b #two", (1, 8), "a comma or the closing ] is missing"),
    ],
)
def test_a_remark_is_not_blamed_for_another_mistake(
    text: str, place: tuple[int, int], said: str
) -> None:
    with pytest.raises(YamlError) as caught:
        load(text)
    assert (caught.value.line, caught.value.col) == place
    assert caught.value.message.startswith(said)


@pytest.mark.parametrize(
    "text",
    [
        "The beams are\\nparallel",
        "More or\\nless?",
        "Something\\nexists",
        "uno\\ne due",
        "for $5\\nu $6",
        "e.g.\\neg",
    ],
)
def test_a_line_break_before_a_word_is_no_formula(text: str) -> None:
    assert load(f'ask: "{text}"').plain["ask"] == text.replace("\\n", "\n")


@pytest.mark.parametrize("text", [r"$a \ne b$", r"\\(a \nless b\\)", r"\\[\nu\\]", r"a \neq b"])
def test_who_meant_a_line_break_and_who_meant_a_formula_are_told_what_to_write(text: str) -> None:
    with pytest.raises(YamlError) as caught:
        load(f'ask: "{text}"')
    assert caught.value.col == re.search(r"(?<!\\)\\n", text).start() + 7  # type: ignore[union-attr]
    assert "single quotes" in caught.value.hint
    assert "line breaks goes below ask: |" in caught.value.hint


@pytest.mark.parametrize(
    ("text", "col"),
    [
        (r'ask: "\ud83d\ude00 how large?"', 7),
        (r'ask: "a \\ud \uDE00"', 14),
        (r'ask: "\uffff"', 7),
        (r'ask: "\U0000d83d"', 7),
    ],
)
def test_half_a_character_is_told_to_be_typed_as_it_is(text: str, col: int) -> None:
    with pytest.raises(YamlError) as caught:
        load(text)
    assert caught.value.col == col
    assert caught.value.hint.startswith("type the character itself")


@pytest.mark.parametrize("key", ["ask", "text", "title"])
def test_a_text_with_a_sign_for_numbers_and_a_blank_is_told_to_go_in_quotes(key: str) -> None:
    with pytest.raises(YamlError) as caught:
        load(f"{key}: Which # is it?")
    assert caught.value.hint == f'put the text in quotes: {key}: "Point # 3"'
