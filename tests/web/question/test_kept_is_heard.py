"""What one place of a page keeps is read by the page's book alone, and heard until its signal."""

from __future__ import annotations

from tests.web.question.node_page import on_page

BOOK = """
const { Book } = await load("answers/book.js");
const { Kept } = await load("store/kept.js");
const book = new Book();
await book.ready;
let [listed, told] = [0, 0];
const { entries } = book.store;
book.store.entries = () => (listed += 1) && entries();
const changed = new Promise((done) => book.addEventListener("change", () => (told += 1) && done()));
await new Kept("meeting").put({ id: "meeting", type: "choice", value: "It stops" });
await changed;
give([listed, told, book.get("worksheet", "meeting").value]);
"""

SIGNAL = """
const { Kept } = await load("store/kept.js");
const { telling } = await load("store/tabs.js");
const other = telling({ put: async () => {} }, "tests");
const said = [];
const [first, second] = [new AbortController(), new AbortController()];
const kept = new Kept("meeting");
await kept.put({ id: "meeting", value: 1 });
await kept.hear(() => said.push("first"), first.signal);
await kept.hear(() => said.push("second"), second.signal);
first.abort();
await other.put("p#meeting", {});
await new Promise((done) => setTimeout(done, 100));
give(said);
"""


def test_of_all_answers_the_book_reads_the_one_that_was_kept() -> None:
    listed, told, value = on_page(BOOK)
    assert (listed, told >= 1, value) == (0, True, "It stops")


def test_a_place_that_has_left_the_page_hears_of_other_tabs_no_more() -> None:
    assert on_page(SIGNAL) == ["second"]
