"""Small sites whose lessons have catalogues: pages, lines at their top, runs computed once."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sim.bridge import protocol
from sim.cli.site.build import build_site
from sim.pages.blocks import bake as baking
from sim.pages.checks.lessons import check_paths
from sim.pages.prepared import pack
from tests.pages.given.small_site import MakeSite, lesson, make_site
from tests.pages.given.translated_site import SAID, TEXT, three, write_words

__all__ = ["make_site"]  # a fixture
SLIDER = "until: 2 s\ncontrols: [{set: A.mass, from: 1 kg, to: 3 kg, step: 1 kg}]"


def built(root: Path) -> dict[str, str]:
    """The lessons of the site as HTML, by their address."""
    site = build_site(root, hosted=False, strict=True)
    assert site is not None
    pages = sorted((site / "worksheets").rglob("*.html"))
    return {p.relative_to(site / "worksheets").as_posix(): p.read_text("utf-8") for p in pages}


def others(page: str) -> list[str]:
    """The addresses in the line of languages, "" for the page itself."""
    found = re.search(r'<p class="carts-languages".*?</p>', page, re.DOTALL)
    return re.findall(r'<a href="([^"]*)"|aria-current', found[0]) if found else []


def test_a_lesson_with_a_catalogue_has_a_page_that_speaks_its_language(make_site: MakeSite) -> None:
    root = three(make_site)
    write_words(root, "first.md", SAID)
    pages = built(root)
    assert list(pages) == ["first.html", "ms/first.html", "second.html", "third.html"]
    made = pages["ms/first.html"]
    assert '<html lang="ms"' in made
    assert "<title>Satu pelajaran" in made
    assert "brillig" in made
    assert "galumphing" not in made
    assert ">Main<" in made  # the words around the scene
    assert 'id="one"' in made  # answers are put together by the ids
    assert "Bahasa Melayu" in pages["second.html"]  # the menu
    index = (root / "site" / "search" / "search_index.json").read_text(encoding="utf-8")
    assert "galumphing" in index


def test_the_search_knows_the_title_and_the_first_lines_of_a_translation(
    make_site: MakeSite,
) -> None:
    """All of it would be loaded by every page, in every language."""
    part = "\n\n## A part\n\nMore words to search: frumious.\n"
    root = three(make_site, TEXT + part)
    write_words(root, "first.md", {**SAID, "More words to search: frumious.": "Lagi: uffish."})
    built(root)
    index = json.loads((root / "site" / "search" / "search_index.json").read_text("utf-8"))
    made = [one for one in index["docs"] if one["location"].startswith("worksheets/ms/")]
    assert [one["title"] for one in made] == ["Satu pelajaran"]
    assert "brillig" in made[0]["text"]
    assert "draf" not in made[0]["text"]
    assert "frumious" in json.dumps(index)
    assert "uffish" not in json.dumps(index)


def test_pages_of_one_lesson_lead_to_each_other(make_site: MakeSite) -> None:
    root = three(make_site)
    write_words(root, "first.md", SAID)
    write_words(root, "first.md", {"A lesson": "一课"}, language="zh-Hans")
    pages = built(root)
    assert others(pages["first.html"]) == ["", "ms/first.html", "zh-Hans/first.html"]
    assert others(pages["ms/first.html"]) == ["../first.html", "", "../zh-Hans/first.html"]
    assert others(pages["second.html"]) == []


def test_links_stay_in_the_language_where_there_is_a_page(make_site: MakeSite) -> None:
    root = three(make_site)
    write_words(root, "first.md", SAID)
    (root / "worksheets" / "ms").mkdir()
    (root / "worksheets" / "ms" / "second.md").write_text(lesson(identity="two"), encoding="utf-8")
    made = built(root)["ms/first.html"]
    assert '<a href="second.html">Kawan</a>' in made
    assert '<a href="../third.html">orang</a>' in made


def test_what_is_not_translated_is_english_and_counted(make_site: MakeSite) -> None:
    root = three(make_site)
    write_words(root, "first.md", {"A lesson": "Satu pelajaran"})
    pages = built(root)
    assert "galumphing" in pages["ms/first.html"]
    assert "2 daripada 3 bahagian masih dalam bahasa Inggeris." in pages["ms/first.html"]
    hints = [
        f
        for f in check_paths([root / "worksheets"], root, hints=True)
        if f.code not in ("relevance", "default")
    ]
    assert [(f.file, f.severity, f.message[:9]) for f in hints] == [
        ("worksheets/words/ms/first.po", "hint", "2 of 3 te")
    ]


def test_a_catalogue_without_a_translation_makes_no_page(make_site: MakeSite) -> None:
    root = three(make_site)
    write_words(root, "first.md", {})
    pages = built(root)
    assert list(pages) == ["first.html", "second.html", "third.html"]
    assert "carts-languages" not in pages["first.html"]


@pytest.mark.parametrize("draft", [True, False])
def test_a_draft_says_so_until_somebody_has_read_it(make_site: MakeSite, draft: bool) -> None:
    root = three(make_site)
    write_words(root, "first.md", SAID, draft=draft)
    made = built(root)["ms/first.html"]
    assert ("Terjemahan ini masih draf" in made) == draft
    assert "bahasa Inggeris" not in made  # nothing is


def test_a_translation_by_hand_wins(make_site: MakeSite) -> None:
    root = three(make_site)
    write_words(root, "first.md", SAID)
    (root / "worksheets" / "ms").mkdir()
    by_hand = TEXT.replace("galumphing", "frabjous").replace("second.md", "../second.md")
    by_hand = by_hand.replace("third.md", "../third.md")
    (root / "worksheets" / "ms" / "first.md").write_text(by_hand, encoding="utf-8")
    pages = built(root)
    assert "frabjous" in pages["ms/first.html"]
    assert "carts-draft" not in pages["ms/first.html"]
    assert others(pages["first.html"]) == ["", "ms/first.html"]


def test_an_old_translation_is_not_used(make_site: MakeSite) -> None:
    root = three(make_site)
    write_words(root, "first.md", SAID)
    path = root / "worksheets" / "first.md"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("galumphing.", "galumphing, once more."), encoding="utf-8")
    catalogue = write_words(root, "first.md", {})
    kept = catalogue.read_text(encoding="utf-8")
    assert "#, fuzzy" in kept
    assert '#| msgid "Words to search: galumphing."' in kept
    assert "brillig" in kept
    made = built(root)["ms/first.html"]
    assert "galumphing, once more" in made
    assert "brillig" not in made


BANK = """\
title: A bank
forms: {all: [one-item, other-item]}
items:
  - id: one-item
    type: single
    ask: Which one?
    options: [{text: The first., correct: true}, {text: The second.}]
  - id: other-item
    type: short
    ask: How many?
    accept: [two]
"""
QUIZ = "\n```quiz\nid: a-form\nform: pre\nmode: practice\nbank: bank.yml\nitems: [one-item]\n```\n"


def test_forms_draw_items_in_the_language_of_their_page(make_site: MakeSite) -> None:
    root = three(make_site, TEXT + QUIZ)
    (root / "worksheets" / "banks").mkdir()
    (root / "worksheets" / "banks" / "bank.yml").write_text(BANK, encoding="utf-8")
    write_words(root, "first.md", SAID)
    write_words(root, "banks/bank.yml", {"Which one?": "Yang mana?"})
    pages = built(root)
    assert "Which one?" in pages["first.html"]
    assert "Yang mana?" in pages["ms/first.html"]
    assert "2 daripada 6 bahagian" in pages["ms/first.html"]  # of the other item nothing is asked


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[Any]]:
    """Everything that is computed from now on."""
    asked: list[Any] = []
    answer = protocol.answer

    def counted(request: Any) -> Any:
        asked.append(request)
        return answer(request)

    monkeypatch.setattr(protocol, "answer", counted)
    baking._kept.cache_clear()
    pack._kept.clear()
    yield asked
    baking._kept.cache_clear()
    pack._kept.clear()


def test_a_build_computes_a_run_once_for_all_languages(
    make_site: MakeSite, runs: list[Any]
) -> None:
    root = three(make_site, TEXT.replace("until: 2 s", f"title: A run\n{SLIDER}"))
    built(root)
    alone = len(runs)
    assert alone > 3  # some of them are prepared ones
    said = SAID | {"A run": "Satu larian"}
    for language in ("ms", "ta", "zh-Hans"):
        write_words(root, "first.md", said, language=language)
    baking._kept.cache_clear()
    pack._kept.clear()
    runs.clear()
    pages = built(root)
    assert len(runs) == alone
    assert "Satu larian" in pages["ms/first.html"]
    assert "Satu larian" not in pages["first.html"]
    tables = {re.search(r'data-prepared="([^"]*)"', pages[f"{n}first.html"])[1]  # type: ignore[index]
              for n in ("", "ms/", "ta/")}  # fmt: skip
    assert len(tables) == 1
