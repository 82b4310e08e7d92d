"""Enter that takes over a word of an input method (Chinese, Tamil) sends nothing off."""

from __future__ import annotations

import pytest

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const { onEnter } = await import(`${source}/shared/enter.js`);
const box = new EventTarget();
let acted = 0;
onEnter(box, () => (acted += 1));
box.dispatchEvent(Object.assign(new Event("keydown"), data));
give(acted);
"""


@pytest.mark.parametrize(
    ("key", "acts"),
    [
        ({"key": "Enter", "keyCode": 13, "isComposing": False}, 1),
        ({"key": "Enter", "keyCode": 13, "isComposing": True}, 0),
        ({"key": "Enter", "keyCode": 13, "repeat": True}, 0),  # held down
        ({"key": "Enter", "keyCode": 229, "isComposing": False}, 0),  # Safari's
        ({"key": "a", "keyCode": 65, "isComposing": False}, 0),
    ],
)
def test_enter_ends_a_line_but_not_while_an_input_method_composes(
    key: dict[str, object], acts: int
) -> None:
    assert in_node(SCRIPT, key) == acts
