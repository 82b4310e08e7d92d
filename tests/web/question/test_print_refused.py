"""A page that is printed as another one comes back, also where the browser refuses to print."""

from __future__ import annotations

import pytest

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const page = new EventTarget();
globalThis.addEventListener = page.addEventListener.bind(page);
let printed = 0;
globalThis.window = { print: () => (printed += 1) };
const { printWith } = await import(`${source}/shared/printing.js`);
let undone = 0;
printWith(() => (undone += 1));
const before = undone;
for (const kind of data) page.dispatchEvent(new Event(kind));
give([printed, before, undone]);
"""


@pytest.mark.parametrize(
    "heard", [["afterprint"], ["pointerdown"], ["keydown"], ["afterprint", "keydown"]]
)
def test_a_page_is_as_before_after_its_print_or_when_it_is_used_again(heard: list[str]) -> None:
    assert in_node(SCRIPT, heard) == [1, 0, 1]
