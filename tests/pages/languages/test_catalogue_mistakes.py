"""A mistake in a catalogue of a lesson is told at its place there."""

from __future__ import annotations

import pytest

from sim.pages.checks.lessons import check_paths
from tests.pages.given.small_site import MakeSite, make_site
from tests.pages.given.translated_site import SAID, TEXT, three, write_words

__all__ = ["make_site"]  # a fixture


def test_a_mistake_in_a_translation_is_told_at_its_place_in_the_catalogue(
    make_site: MakeSite,
) -> None:
    pairs = (
        "\n```question\nid: q\ntype: matching\nask: Which?\npairs:\n"
        "  - {left: one, right: first}\n  - {left: two, right: second}\n```\n"
    )
    root = three(make_site, TEXT + pairs)
    # on the right all must differ
    same = {"one": "satu", "two": "dua", "first": "sama", "second": "sama"}
    catalogue = write_words(root, "first.md", SAID | same)
    (found,) = check_paths([root / "worksheets"], root)
    assert (found.file, found.code) == ("worksheets/words/ms/first.po", "twice")
    assert "at the translation of “second”" in found.message
    lines = catalogue.read_text(encoding="utf-8").splitlines()
    assert lines[found.line - 1].startswith("msgid")


@pytest.mark.parametrize(
    ("said", "code"),
    [("[Kawan](second.md)", "marks-changed"), ("# [K](second.md) [o](third.md)", "not-one-part")],
)
def test_a_translation_that_loses_a_link_or_turns_into_a_heading_is_a_finding(
    make_site: MakeSite, said: str, code: str
) -> None:
    root = three(make_site)
    write_words(root, "first.md", SAID | {list(SAID)[2]: said})
    (found,) = check_paths([root / "worksheets"], root)
    assert (found.file, found.code, found.severity) == (
        "worksheets/words/ms/first.po",
        code,
        "error",
    )


def test_a_broken_catalogue_is_named_with_its_line(make_site: MakeSite) -> None:
    root = three(make_site)
    catalogue = write_words(root, "first.md", SAID)
    text = catalogue.read_text(encoding="utf-8").replace('msgstr "Satu', "msgstr Satu")
    catalogue.write_text(text, encoding="utf-8")
    (found,) = check_paths([root / "worksheets"], root)
    line = text.splitlines()[found.line - 1]
    assert (found.file, found.code) == ("worksheets/words/ms/first.po", "po")
    assert "msgstr Satu" in line
