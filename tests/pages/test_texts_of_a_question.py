"""What a question's texts become: one line stays one, whatever sign it begins with."""

from __future__ import annotations

import pytest

from sim.pages.question.inside import to_html, to_inline


@pytest.mark.parametrize(
    "line", ["- 0.4 m/s", "+ 0.4 m/s", "# of carts", "1. law", "* or +", "[1]: a", "***"]
)
def test_a_line_keeps_the_sign_it_begins_with(line: str) -> None:
    """A velocity without its minus would be another answer."""
    assert to_inline(line) == line
    assert to_html(line) == f"<p>{line}</p>"


def test_a_line_that_compares_is_no_quotation() -> None:
    assert to_inline("> 2 m/s") == "&gt; 2 m/s"


def test_marks_inside_of_a_line_are_read() -> None:
    assert to_inline("- **0.4** m/s, \\(v_1\\)") == (
        '- <strong>0.4</strong> m/s, <span class="arithmatex">\\(v_1\\)</span>'
    )


def test_several_lines_may_be_a_list_or_a_table() -> None:
    assert "<li>two</li>" in to_html("- one\n- two")
    assert "<td>2</td>" in to_inline("| a |\n|---|\n| 2 |")
