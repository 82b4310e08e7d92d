"""What a page keeps in the browser's database, waited for before the page goes."""

from __future__ import annotations

from playwright.sync_api import Page

# A transaction that would write begins when all that were asked for before it are done.
AFTER_ALL = """async (ending) => {
  const [{ name }] = (await indexedDB.databases()).filter(({ name }) => name.endsWith(ending));
  const asked = indexedDB.open(name);
  const base = await new Promise((done) => (asked.onsuccess = () => done(asked.result)));
  const last = base.transaction([...base.objectStoreNames], "readwrite");
  await new Promise((done) => (last.oncomplete = done));
  base.close();
}"""
MEASURED, DRAFTS = "-measured", "~teacher"


def written(page: Page, ending: str) -> None:
    """Wait until all that the page has given to the store of this name is on the disk."""
    page.evaluate(AFTER_ALL, ending)
