"""The code of a form on paper: answers in letters, and what a slip of the pen is found by."""

from __future__ import annotations

import random
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim.lesson.handin import ALPHABET, HandInError, decode, encode, fits
from tests.web.scene.given.widget_site import in_node

HASH = "pre:0123456789ab"

SHEETS = st.lists(st.integers(2, 6), min_size=1, max_size=15).flatmap(
    lambda options: st.tuples(st.just(options), st.tuples(*(st.integers(0, n) for n in options)))
)


@given(SHEETS)
def test_a_code_gives_the_answers_back(sheet: tuple[list[int], tuple[int, ...]]) -> None:
    options, chosen = sheet
    code = encode(options, chosen, HASH)
    assert re.fullmatch(r"(?:[0-9A-HJKMNP-TV-Z]{4}-){2}[0-9A-HJKMNP-TV-Z]{4}", code)
    assert decode(options, code, HASH) == chosen
    spoken = code.lower().replace("0", "o").replace("1", "l").replace("-", " ")
    assert decode(options, spoken, HASH) == chosen


@given(SHEETS, st.integers(0, 11), st.sampled_from(ALPHABET))
def test_one_wrong_letter_is_found(
    sheet: tuple[list[int], tuple[int, ...]], at: int, letter: str
) -> None:
    options, chosen = sheet
    code = encode(options, chosen, HASH).replace("-", "")
    if code[at] != letter:
        with pytest.raises(HandInError):
            decode(options, code[:at] + letter + code[at + 1 :], HASH)


@given(SHEETS, st.integers(0, 10))
def test_two_letters_that_changed_places_are_found(
    sheet: tuple[list[int], tuple[int, ...]], at: int
) -> None:
    options, chosen = sheet
    code = encode(options, chosen, HASH).replace("-", "")
    swapped = code[:at] + code[at + 1] + code[at] + code[at + 2 :]
    if swapped != code:
        with pytest.raises(HandInError):
            decode(options, swapped, HASH)


def test_the_code_of_another_form_is_refused() -> None:
    code = encode([4] * 15, [1] * 15, HASH)
    for other in ("post:0123456789ab", "pre:ba9876543210"):
        with pytest.raises(HandInError):
            decode([4] * 15, code, other)


def test_a_code_that_counts_on_beyond_the_last_answers_is_refused() -> None:
    """Its check agrees: whoever made it up knows the form, and no answers stand behind it."""
    options = [4] * 3
    last = encode(options, options, HASH)
    assert decode(options, last, HASH) == (4, 4, 4)
    longer = encode([*options, 4], [1, 0, 0, 0], HASH)  # the next number: 5³
    with pytest.raises(HandInError, match="another form"):
        decode(options, longer, HASH)


def test_a_form_that_is_too_long_or_asks_for_words_has_no_code() -> None:
    assert fits([5] * 15)
    assert not fits([5] * 20)
    assert not fits([4, 0])
    assert not fits([])


def test_the_page_writes_the_same_codes() -> None:
    dice = random.Random(3)
    sheets = []
    for _ in range(200):
        options = [dice.randint(2, 6) for _ in range(dice.randint(1, 15))]
        sheets.append([options, [dice.randint(0, n) for n in options]])
    made = in_node(
        """const { encode, fits } = await import(source + "/question/handin.js");
        give(data.sheets.map(([o, c]) => [fits(o), encode(o, c, data.hash)]));""",
        {"sheets": sheets, "hash": HASH},
    )
    assert made == [[fits(o), encode(o, c, HASH)] for o, c in sheets]
