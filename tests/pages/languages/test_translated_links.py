"""Links of a translated page, one folder further down."""

from __future__ import annotations

from sim.pages.translate.translation import _moved_links


def test_links_lead_to_the_same_language_where_it_is_there_and_else_to_where_they_led() -> None:
    text = "[a](mein plan.md#x) [b](mein%20plan.md) [c](<mein plan.md>) [d](other.md 'it')\n"
    moved = _moved_links(text, {"mein plan.md"})
    assert moved == text.replace("(other", "(../other")
    assert _moved_links(text, ()) == text.replace("(m", "(../m").replace("<m", "<../m").replace(
        "(o", "(../o"
    )
