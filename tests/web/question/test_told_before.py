"""“My answers” tells beforehand what a code word is, and what the count at the foot counts."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const { parseHTML } = await import("linkedom");
const lesson = JSON.stringify({ lesson: "p", hash: "", items: [] });
const { document } = parseHTML(`<html><body>
  <script type="application/json" id="carts-lesson">${lesson}</script></body></html>`);
Object.assign(globalThis, { document });
const { whoPart } = await import(`${source}/answers/panel-who.js`);
const { listPart } = await import(`${source}/answers/panel-list.js`);
const none = () => null;
const book = { student: "", entries: () => [], page: "p", store: { get: none }, get: none };
give([whoPart, listPart].map((part) => part(book).textContent));
"""


def test_a_code_word_s_rule_and_what_counts_are_told_before_anybody_is_refused() -> None:
    who, listed = in_node(SCRIPT, None)
    assert "A code word has at least four letters or digits." in who
    assert "questions and predictions, without those “for more”" in listed
