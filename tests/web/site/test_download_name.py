"""The name of a downloaded lesson, also where the server shows no name of a file."""

from __future__ import annotations

import pytest

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const { parseHTML } = await import("linkedom");
const window = parseHTML("<html><body></body></html>");
globalThis.document = window.document;
Object.defineProperty(document, "baseURI", { value: "https://school.example/" });
globalThis.location = { pathname: data, href: `https://school.example${data}` };
globalThis.fetch = async () => ({ ok: true, text: async () => "<!doctype html>" });
URL.createObjectURL = () => "blob:";
URL.revokeObjectURL = () => {};
let saved = "";
window.HTMLAnchorElement.prototype.click = function () {
  saved = this.download;
};
const { downloadLine } = await import(`${source}/hosted/download.js`);
const line = downloadLine("shell.txt", "https://school.example/assets/");
line.querySelector("button").dispatchEvent(new window.Event("click"));
await new Promise((done) => setTimeout(done, 50));
give(saved);
"""


@pytest.mark.parametrize(
    ("path", "name"),
    [
        ("/worksheets/third-law.html", "third-law.html"),
        ("/worksheets/third-law", "third-law.html"),
        ("/worksheets/third-law/", "third-law.html"),
        ("/", "lesson.html"),
    ],
)
def test_a_download_has_the_name_of_its_page(path: str, name: str) -> None:
    assert in_node(SCRIPT, path) == name
