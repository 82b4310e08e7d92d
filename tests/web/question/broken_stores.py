"""Browsers whose stores are missing, late or refuse, for pages that keep answers."""

from __future__ import annotations

from playwright.sync_api import Page

from tests.web.question.question_site import ready

NO_DATABASE = "Object.defineProperty(window, 'indexedDB', { get() { throw new Error('no'); } });"
NO_TEXT_STORE = (
    "Object.defineProperty(window, 'localStorage', { get() { throw new Error('no'); } });"
)
# Firefox with all cookies blocked: no store opens, and tabs cannot tell each other either.
BLOCKED = """
for (const name of ["localStorage", "sessionStorage", "BroadcastChannel"]) {
  const refuse = () => { throw new DOMException("The operation is insecure.", "SecurityError"); };
  const found = name === "BroadcastChannel" ? { value: refuse } : { get: refuse };
  Object.defineProperty(window, name, { ...found, configurable: true });
}
IDBFactory.prototype.open = () => {
  throw new DOMException("The operation is insecure.", "SecurityError");
};"""
REFUSING = """IDBObjectStore.prototype.put = () => {
  throw new DOMException("full", "QuotaExceededError");
};"""


# A store opens when it is told to, so that what is done before is before on any machine.
WHEN_TOLD = """new Promise((open) =>
  (window.mayOpen ? open() : addEventListener("may-open", open)))"""


def late_store(when: str) -> str:
    """A script: the database opens later. `when`: an expression of JavaScript, a promise."""
    return f"""const open = IDBFactory.prototype.open;
IDBFactory.prototype.open = function (...asked) {{
  const request = open.apply(this, asked);
  Object.defineProperty(request, "onsuccess", {{
    set(then) {{
      request.addEventListener("success", (event) => {when}.then(() => then(event)));
    }},
  }});
  return request;
}};"""


def tell_to_open(page: Page) -> None:
    """The store that waits to be told (`WHEN_TOLD`) opens."""
    page.evaluate("window.mayOpen = dispatchEvent(new Event('may-open'))")


def again_with(page: Page, script: str, address: str = "") -> Page:
    """The page, or a new one at this address, with the script before all of its own."""
    page.add_init_script(script)
    if address:
        page.goto(address)
    else:
        page.reload()
    return ready(page)
