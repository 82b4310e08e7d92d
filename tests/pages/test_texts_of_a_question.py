"""What a question's texts become: one line stays one, whatever sign it begins with."""

from __future__ import annotations

import pytest

from sim.lesson import read_question
from sim.pages.question.inside import to_html, to_inline
from sim.pages.question.render import render_question


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


@pytest.mark.parametrize(
    ("start", "inside"),
    [("The force …", True), ("equal in …, opposite in …, they act on …", False)],
)
def test_a_long_beginning_of_a_sentence_stands_above_the_box(start: str, inside: bool) -> None:
    """Inside of a box of one line, 289 px on a phone, it was cut."""
    plain = {"id": "a", "type": "short", "ask": "Go on.", "start": start, "accept": ["x"]}
    made = render_question(read_question(plain))
    assert (f'placeholder="{start}"' in made) is inside
    assert (f"You can begin like this: “{start}”" in made) is not inside
