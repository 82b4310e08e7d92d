"""YAML with places: what people mean is read, what could be misunderstood is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim.pages.text.yaml.source import MAX_CHARACTERS, YamlError, load


def test_values_are_plain_and_know_their_place() -> None:
    source = load("carts:\n  A: {mass: 500 g, velocity: -2}\neffects:\n  - push: {force: 2 N}\n")
    assert source.plain == {
        "carts": {"A": {"mass": "500 g", "velocity": -2}},
        "effects": [{"push": {"force": "2 N"}}],
    }
    assert source.place(("carts", "A", "mass")) == (2, 13)
    assert source.key_place(("carts", "A", "mass")) == (2, 7)
    assert source.place(("effects", 0, "push", "force")) == (4, 19)


def test_a_missing_key_is_placed_at_the_name_it_belongs_under() -> None:
    source = load("carts:\n  A: {mass: 1}\n")
    assert source.place(("carts", "A", "position")) == (2, 3)
    assert source.place(("until",)) == (1, 1)


def test_places_count_from_where_the_text_stands_in_its_file() -> None:
    source = load("mass: 1\n", first_line=12, first_col=5)
    assert source.place(("mass",)) == (12, 11)


@pytest.mark.parametrize(
    ("text", "place", "said"),
    [
        ("mass:\u00a00.5 kg", (1, 6), "a character that nobody sees (U+00A0)"),
        ("carts:\n\u00a0 A: {mass: 1}", (2, 1), "a character that nobody sees (U+00A0)"),
        ("ma\u200bss: 1", (1, 3), "a character that nobody sees (U+200B)"),
        ("effects:\n  – friction: {coefficient: 0.1}", (2, 3), "a long dash begins this line"),
        ("ask: Join # of 50%", (1, 11), "what comes after # is left out"),
        ("options:\n  - text: Item # 3", (2, 16), "what comes after # is left out"),
        ("\tmass: 1", (1, 1), "a tab character"),
        ("A: {mass：1 kg, position: 1 m}", (1, 9), "a wide colon"),
        ("A: {mass: 1 kg，position: 1 m}", (1, 15), "a wide comma"),
        ("ask: “Ana: it is larger.” Is it?", (1, 6), "typographic quotes"),
        ("options:\n  - {text: “Yes, it is.”, correct: true}", (2, 12), "typographic quotes"),
        ("answer: “0.25 m/s”", (1, 9), "the quotes (“ ”) would be part of this number"),
        ("A: {mass: „0,5 kg“, position: 1 m}", (1, 11), "the quotes (“ ”) would be part"),
        ("choice:\n  - A\n  -B", (3, 3), "a list entry begins with a hyphen and a space"),
        ("choice:\n  • A\n  • B", (2, 3), "“•” begins no entry of a list"),
        ("choice:\n  * A\n  * B", (2, 3), "“*” begins no entry of a list"),
    ],
)
def test_what_a_word_processor_leaves_behind_is_named_where_it_stands(
    text: str, place: tuple[int, int], said: str
) -> None:
    with pytest.raises(YamlError) as caught:
        load(text)
    assert (caught.value.line, caught.value.col) == place
    assert caught.value.message.startswith(said)


def test_typographic_quotes_inside_a_text_are_its_own() -> None:
    texts = ("ask: Ana says “no”. Is it so?", "ask: “No”, says Ana.", 'ask: "“Ana: no”"')
    texts += ("accept: “3 N”", "rubric: {1: “3 N”, 0: none}", 'ask: "He says, mass: “5 kg”, so."')
    texts += ("ask: A cart that is\n  -how odd!- moving", "explain: |\n  so:\n  • one\n  * two")
    for text in (*texts, "options:\n  - {text: “Yes.”, correct: true}"):
        assert load(text).plain


@pytest.mark.parametrize(
    ("text", "place", "said"),
    [
        ("ask: **Explain** it.", (1, 6), "a text cannot begin with *"),
        ("id: a\nask: > 3 N?", (2, 6), "a text cannot begin with >"),
        ("ask: - 3 N?", (1, 6), "a text cannot begin with -"),
        (r'ask: "What is \(v\)?"', (1, 15), "a backslash means something else in double quotes"),
        ("ask: 'What's the force?'", (1, 6), "the text goes on after a single quote"),
        ('ask: "Normal" force', (1, 6), 'the text goes on after the closing "'),
        ("ask: [Hard] Explain", (1, 6), "the text goes on after the closing ]"),
        ('a: "x\nb: 1\nc: 2', (1, 4), "the closing quote is missing"),
        (
            'o:\n  - {text: "No", f: "Yes.}\n  - {text: "Yes"}',
            (2, 21),
            "the closing quote is missing",
        ),
        ('ask: "What\no:\n  - {text: "A b"}', (1, 6), "the closing quote is missing"),
        (
            'ask: |\n  A 5" pipe\nx: [a, b\nd: 1',
            (3, 4),
            "a comma or the closing ] is missing before line 4",
        ),
    ],
)
def test_a_text_that_needs_quotes_is_named_where_it_begins(
    text: str, place: tuple[int, int], said: str
) -> None:
    with pytest.raises(YamlError) as caught:
        load(text)
    assert (caught.value.line, caught.value.col) == place
    assert caught.value.message == said


def test_a_ratio_is_told_to_go_in_quotes() -> None:
    with pytest.raises(YamlError) as caught:
        load("text: 2:1")
    assert 'in quotes: "2:1"' in caught.value.hint


@pytest.mark.parametrize(
    "text",
    [
        "ask: |\n  – A dash, 10\u00a0000 km and a # in prose\n  go on\nid: a",
        "mass: 0.5 kg # a remark",
        'ask: "Join # of 50%"',
        "ask: 10\u00a0000 km away",
        "title: No blank before it#1",
        "# title: a whole line of remark # 2",
        "carts: #all of them\n  A: 1 kg # heavy\n  #B: 2 kg\n  C: 3 kg\n  #end",
        "a: 'Cart #2'\nb: |\n  Cart #2\nc: [\"Cart #2\"]",
        "hints: x ###### y",
    ],
)
def test_the_same_signs_in_prose_and_remarks_are_fine(text: str) -> None:
    load(text)


@pytest.mark.parametrize(
    ("written", "read"),
    [
        ("0", 0),
        ("-12", -12),
        ("+5", 5),
        ("0.10", "0.10"),
        ("1e9", "1e9"),
        ("1.5e-3", "1.5e-3"),
        (".5", ".5"),
        (".nan", ".nan"),
        (".inf", ".inf"),
        ("0.1000000000000000055511151231257827", "0.1000000000000000055511151231257827"),
        ("true", True),
        ("~", None),
        ("", None),
        ("2 km/h", "2 km/h"),
        ('"on"', "on"),
        ("2026-11-21", "2026-11-21"),
    ],
)
def test_a_number_keeps_its_exact_text(written: str, read: object) -> None:
    value = load(f"key: {written}\n").plain["key"]
    assert value == read
    assert type(value) is type(read)


@pytest.mark.parametrize(
    ("text", "line", "col", "words"),
    [
        ("mass:\t1", 1, 6, "a tab character"),
        ("carts:\n\tA: {mass: 1}", 2, 1, "a tab character"),
        ("carts:\n  \tA: {mass: 1}", 2, 3, "a tab character"),
        ("until: 1:30", 1, 8, "base 60"),
        ("until: 1:30.5", 1, 8, "base 60"),
        ("until: 0x10", 1, 8, "0x10"),
        ("until: 0b11", 1, 8, "0b11"),
        ("until: 010", 1, 8, "010"),
        ("until: 1_000", 1, 8, "underscore"),
        ("until: 1_0.5", 1, 8, "underscore"),
        ("No: 1", 1, 1, "the name “No”"),
        ("on: 1", 1, 1, "the name “on”"),
        ("slow: off", 1, 7, "“off” as true or false"),
        ("a: &x 1", 1, 4, "anchors and aliases"),
        ("a: *x", 1, 4, "anchors and aliases"),
        ("a: !!python/object/apply:os.system [ls]", 1, 4, "the tag"),
        ("a: !ENV HOME", 1, 4, "the tag !ENV"),
        ("<<: {a: 1}", 1, 1, "merging"),
        ("mass: 1\nvelocity: 2\nmass: 3", 3, 1, "written twice (first in line 1)"),
        ("{mass: 1, mass: 2}", 1, 11, "written twice"),
        ("mass: 1\n  velocity: 2", 2, 11, "a colon where none is expected"),
        ("carts: {A: {mass: 1}", 1, 21, "the closing } is missing"),
        ("show: [x, v", 1, 12, "the closing ] is missing"),
        ("title: 'A cart", 1, 15, "the closing quote is missing"),
        ("mass: 1\nvelocity 2\nlength: 3", 2, 1, "a colon is missing"),
        ("- mass: 1", 1, 1, "expected lines of “key: value”"),
        ("mass: @1", 1, 7, "a text cannot begin with @"),
        ("mass: \x07", 1, 7, "cannot be read"),
        ("a: 1\n---\nb: 2", 2, 1, "a second text"),
        ("? [a]\n: 1", 1, 3, "cannot be a list"),
        ("[" * 20_000, 1, 1, "nested too deeply"),
        ("a: " + "9" * 5000, 1, 4, "a number of 5000 characters"),
    ],
)
def test_a_trap_is_refused_with_place_message_and_hint(
    text: str, line: int, col: int, words: str
) -> None:
    with pytest.raises(YamlError) as caught:
        load(text)
    assert (caught.value.line, caught.value.col) == (line, col)
    assert words in caught.value.message
    assert caught.value.hint


def test_a_text_far_too_long_is_refused_before_it_is_read() -> None:
    with pytest.raises(YamlError, match="at most"):
        load("a: 1 #" + "x" * MAX_CHARACTERS)


def test_a_bomb_of_aliases_is_refused_at_its_first_anchor() -> None:
    bomb = "a: &a [x, x]\n" + "".join(f"b{i}: &b{i} [*a, *a]\n" for i in range(9))
    with pytest.raises(YamlError, match="anchors"):
        load(bomb)


@settings(derandomize=True, deadline=None, max_examples=300)
@given(st.text(alphabet=st.sampled_from(list("ab1.:-{}[],'\"#&*!|>%@` \t\n\\x0")), max_size=60))
def test_any_text_gives_values_or_an_error_with_a_place(text: str) -> None:
    try:
        source = load(text)
    except YamlError as error:
        assert error.line >= 1
        assert error.col >= 1
        assert error.hint
    else:
        assert isinstance(source.plain, dict)


def test_every_scene_of_the_registry_is_read() -> None:
    for path in sorted((Path(__file__).parents[1] / "scenes").glob("*.yml")):
        assert load(path.read_text(encoding="utf-8")).plain["carts"], path.name
