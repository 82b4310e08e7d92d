"""What the panel calls a piece of a lesson is what its reader sees, signs of Markdown left out."""

from __future__ import annotations

import pytest

from tests.web.scene.given.widget_site import in_node

TITLES = [
    ({"kind": "text", "text": "## Cart #2 and the wall\n\nMore."}, "Cart #2 and the wall"),
    (
        {"kind": "text", "text": "## 3. Does a wall push? {: data-minutes=5 }"},
        "3. Does a wall push?",
    ),
    ({"kind": "text", "text": "> If *F* > 0, it pushes."}, "If F > 0, it pushes."),
    ({"kind": "text", "text": "1. First [the film](f.mp4)"}, "First the film"),
    ({"kind": "text", "text": "* one\n* two"}, "one"),
    ({"kind": "text", "text": '!!! problem "In the car park"'}, "In the car park"),
    ({"kind": "text", "text": "<!-- later -->\n#\n"}, "+ text here"),
    ({"kind": "top", "text": "title: Lesson #1\norder: 2"}, "Lesson #1"),
    (
        {"kind": "block", "text": "id: a", "title": "Cart #2 > cart #1", "id": "a"},
        "Cart #2 > cart #1",
    ),
    (
        {"kind": "block", "text": "", "title": "| t | x |\n|---|--:|\n| 1 | 2 |\n\nHow fast?"},
        "How fast?",
    ),
    ({"kind": "block", "text": "", "title": "| *t* | x |\n|---|--:|\n| 1 | 2 |"}, "t, x"),
    ({"kind": "text", "text": "| time | place |\n|---|---|\n| 1 | 2 |"}, "time, place"),
    ({"kind": "block", "text": "", "title": "|v| of A?"}, "|v| of A?"),
]


@pytest.mark.parametrize(("piece", "title"), TITLES, ids=[title for _, title in TITLES])
def test_a_piece_is_called_what_a_reader_sees_first(piece: dict[str, str], title: str) -> None:
    found = in_node(
        """const { titleOf } = await import(source + "/teach/piece-title.js");
        give(titleOf(data));""",
        piece,
    )
    assert found == title
