"""Links of a translated page, one folder further down."""

from __future__ import annotations

from sim.pages.checks.lessons import check_paths
from sim.pages.translate.translation import _moved_links
from tests.pages.given.small_site import MakeSite, make_site
from tests.pages.given.translated_site import SAID, TEXT, three, write_words

__all__ = ["make_site"]  # a fixture


def test_links_lead_to_the_same_language_where_it_is_there_and_else_to_where_they_led() -> None:
    text = "[a](mein plan.md#x) [b](mein%20plan.md) [c](<mein plan.md>) [d](other.md 'it')\n"
    moved = _moved_links(text, {"mein plan.md"})
    assert moved == text.replace("(other", "(../other")
    assert _moved_links(text, ()) == text.replace("(m", "(../m").replace("<m", "<../m").replace(
        "(o", "(../o"
    )


def test_a_link_to_a_page_of_the_docs_is_as_right_in_a_translation_as_in_its_lesson(
    make_site: MakeSite,
) -> None:
    root = three(make_site, TEXT + "\nThe [sheet](../teachers/sheet.md).\n")
    said = {"The [sheet](../teachers/sheet.md).": "[Lembaran](../teachers/sheet.md)."}
    write_words(root, "first.md", SAID | said)
    wrong = [(f.file, f.code) for f in check_paths([root / "worksheets"], root)]
    named = ("worksheets/first.md", "broken-link")
    assert wrong == [named]  # told once, of the lesson
    sheet = root / "docs" / "teachers" / "sheet.md"
    sheet.parent.mkdir(parents=True)
    sheet.write_text("# A sheet\n", encoding="utf-8")
    assert not check_paths([root / "worksheets"], root)
