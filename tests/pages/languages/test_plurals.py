"""A sentence that counts has the form that its number takes in the language, in Python and page."""

from __future__ import annotations

import json
import pickle
from collections.abc import Mapping
from gettext import c2py
from pathlib import Path
from typing import Any

import pytest
from babel.messages.plurals import PLURALS
from py_mini_racer import MiniRacer

from sim.pages.language import LANGUAGES, speaking, told, tr, tr_counted, words
from sim.pages.language.plurals import rule_of
from sim.scene.said import FORMS, RULE, counted, from_wire, wire

ROOT = Path(__file__).parents[3]
ONE, MORE = "1 run of {who}", "{n} runs of {who}"
# Three forms, as in Polish: 1; 2 to 4, 22 to 24, …; all others.
POLISH = "(n==1 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2)"
WORDS = {
    MORE: FORMS.join(("{n} przebieg: {who}", "{n} przebiegi: {who}", "{n} przebiegów: {who}")),
    RULE: rule_of(POLISH),
}
SAID = {
    0: "przebiegów", 1: "przebieg", 2: "przebiegi", 5: "przebiegów", 12: "przebiegów",
    22: "przebiegi", 112: "przebiegów", 1_004: "przebiegi", 1_000_012: "przebiegów",
}  # fmt: skip


def runs(n: int) -> str:
    return counted(ONE, MORE, n=n, who="Ana")


@pytest.mark.parametrize(("n", "form"), SAID.items())
def test_a_number_takes_its_form(n: int, form: str) -> None:
    with speaking(WORDS):
        assert told(runs(n)) == f"{n:,} {form}: Ana"
        assert tr_counted(ONE, MORE, n=n, who="Ana") == f"{n:,} {form}: Ana"


@pytest.mark.parametrize("words_", [{}, WORDS], ids=["English", "Polish"])
def test_the_page_says_what_python_says(words_: Mapping[str, str]) -> None:
    page = MiniRacer()
    source = (ROOT / "sim" / "view" / "language.js").read_text(encoding="utf-8")
    page.eval(f"globalThis.cartsWords = {json.dumps(words_)};")
    page.eval(source.replace("export function", "function"))

    def said(call: str, *given: Any) -> Any:
        return page.eval(f"{call}({', '.join(map(json.dumps, given))})")

    with speaking(words_):
        for n in SAID:
            assert said("told", wire(runs(n))) == told(runs(n))
        for n in (0, 1, 2, 5, 22, 112):
            assert said("counted", ONE, MORE, n, {"who": "Ana"}) == told(runs(n))


def test_english_has_a_form_for_one_and_one_for_all_else() -> None:
    assert [runs(n) for n in (0, 1, 2, 1_000)] == [
        "0 runs of Ana", "1 run of Ana", "2 runs of Ana", "1,000 runs of Ana"
    ]  # fmt: skip


WAYS = (lambda it: from_wire(wire(it)), lambda it: pickle.loads(pickle.dumps(it)))


@pytest.mark.parametrize("way", WAYS)
def test_it_comes_whole_over_the_wire_and_to_another_process(way: Any) -> None:
    with speaking(WORDS):
        assert told(way(runs(2))) == "2 przebiegi: Ana"


def test_a_form_that_a_catalogue_lacks_is_told_in_its_last_one() -> None:
    with speaking({**WORDS, MORE: "{n} × {who}"}):
        assert told(runs(5)) == "5 × Ana"


@pytest.mark.parametrize("language", sorted(PLURALS))
def test_the_rule_of_every_language_that_gettext_knows_fits_its_table(language: str) -> None:
    expression = PLURALS[language][1]
    form, rule = c2py(expression), rule_of(expression)
    for n in (*range(1_100), 99_901, 123_411, 999_999):  # at a million Breton has one more form
        assert int(rule[n if n < 200 else 100 + n % 100]) == form(n)


def test_a_rule_that_looks_at_more_than_two_digits_is_refused() -> None:
    with pytest.raises(ValueError, match="last two digits"):
        rule_of("n % 1000 == 0")


def test_nothing_is_said_where_nothing_is_to_be_said() -> None:
    """No catalogue has words for an empty text, such as a question without a level has."""
    page = MiniRacer()
    page.eval(f"globalThis.cartsWords = {json.dumps(WORDS)};")
    source = (ROOT / "sim" / "view" / "language.js").read_text(encoding="utf-8")
    page.eval(source.replace("export function", "function"))
    assert page.eval('told("") + tr("")') == ""
    with speaking(WORDS):
        assert told("") + tr("") == ""
    assert not [language for language in LANGUAGES if "" in words(language)]


def test_every_catalogue_gives_its_rule() -> None:
    forms = {language: set(words(language)[RULE]) for language in LANGUAGES if language != "en"}
    assert forms == {"ms": {"0"}, "ta": {"0", "1"}, "zh-Hans": {"0"}}
