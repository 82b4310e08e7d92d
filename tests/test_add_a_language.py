"""The guide's example is one file and one line: then a page and a report speak the language."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.guides import copy_project, python, shown_in


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the program with the file and the line of the guide, and every sentence."""
    copy = copy_project(tmp_path_factory.mktemp("project"), "sim")
    for title, text in shown_in("add-a-language.md").items():
        place, _, table = title.partition(", in ")
        path, head = copy / place, f"{table} = {{\n"
        before = path.read_text(encoding="utf-8") if table else head
        assert head in before
        path.write_text(before.replace(head, head + text, 1) if table else text, encoding="utf-8")
    assert re.search(r"pl: .* not translated yet", python(copy, "-m", "sim.pages.language.extract"))
    return copy


def test_its_sentences_are_told_and_counted_and_the_others_stay_english(project: Path) -> None:
    program = """
from sim.classroom.show.own_runs import own_run_sentence
from sim.pages.language import language_of, of_page, speaking, told, tr, words
from sim.scene.said import said
assert language_of("pl-PL") == "pl" and of_page(None, "worksheets/pl/a.md", "en") == "pl"
with speaking(words("pl")):
    for n in (1, 2, 5, 22):
        row = {"kind": "challenge", "n": 3, "runs": n, "found": 0}
        print(told(own_run_sentence(row)))
    print(tr("Play"), tr("Undo"))
"""
    assert python(project, "-c", program).splitlines() == [
        "3 students, 1 przebieg; nikt żadnego nie znalazł.",
        "3 students, 2 przebiegi; nikt żadnego nie znalazł.",
        "3 students, 5 przebiegów; nikt żadnego nie znalazł.",
        "3 students, 22 przebiegi; nikt żadnego nie znalazł.",
        "Odtwórz Undo",
    ]


def test_a_page_gets_its_words_and_the_form_of_each_number(project: Path) -> None:
    program = """
from sim.pages.language import words_script
print(words_script("pl"))
"""
    script = python(project, "-c", program)
    assert '"Play":"Odtwórz"' in script
    assert '"\\u0000":"2011122222' in script


def test_make_words_keeps_what_was_translated_and_shows_what_is_not(project: Path) -> None:
    text = (project / "sim/pages/language/catalogues/pl.po").read_text(encoding="utf-8")
    assert 'msgstr[2] "{n} przebiegów"' in text
    assert 'msgid "Undo"\nmsgstr ""' in text
    assert text.count("nplurals=3;") == 1
