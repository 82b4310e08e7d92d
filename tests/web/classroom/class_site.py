"""The page “Class results” in a folder, files dropped on it, and what it saves."""

from __future__ import annotations

import html

from playwright.sync_api import FilePayload, Page, expect

from sim.classroom.files.reading import Source
from tests.classroom.given.makers import bank, keys
from tests.web.runtime.boot_site import STRICT

BANK = bank(8, words=1)


KEY = Source("carts.key.json", keys(BANK).encode())


PAGE = f"""<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{html.escape(STRICT)}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Class results</title><link rel="icon" href="data:,">
<link rel="stylesheet" href="assets/carts/carts.css"></head>
<body><main><h1>Class results</h1><carts-class></carts-class></main>
<script src="assets/carts/class-keys.js"></script>
<script src="assets/carts/class.js"></script></body></html>
"""


# Firefox's driver tells of no download: what is handed to the browser is caught instead, and the
# page is then as it was.
CATCH = """() => {
  const make = URL.createObjectURL;
  const blobs = [];
  URL.createObjectURL = (blob) => {
    if (blob.type !== "text/javascript") blobs.push(blob); // a worker may start just then
    return make.call(URL, blob);
  };
  window._caught = { make, blobs };
}"""


LAST = """async () => {
  const { make, blobs } = window._caught;
  while (!blobs.length) await new Promise((resolve) => setTimeout(resolve, 50));
  URL.createObjectURL = make;
  delete window._caught;
  const bytes = new Uint8Array(await blobs.pop().arrayBuffer());
  return Array.from(bytes);
}"""


# The next print is noted on the element, and opens no window.
NOTE_PRINT = """() => {
  const print = window.print;
  window.print = () => {
    window.print = print;
    document.querySelector("carts-class").dataset.printed = "yes";
  };
}"""


PRINTED = "dispatchEvent(new Event('afterprint'))"


def saved(page: Page, button: str) -> bytes:
    """What a button hands to the browser to be saved."""
    page.evaluate(CATCH)
    page.locator(button).click()
    return bytes(page.evaluate(LAST))


def choose(page: Page, files: list[Source], group: int = 0) -> None:
    payloads: list[FilePayload] = [
        {"name": f.name, "mimeType": "application/octet-stream", "buffer": f.content} for f in files
    ]
    page.locator(".carts-class-drop").nth(group).locator(
        ".carts-class-files"
    ).first.set_input_files(payloads)


def complete(page: Page) -> None:
    expect(page.locator("carts-class")).to_have_attribute("data-state", "complete", timeout=60_000)
