"""A page with a text store and nothing else, for scripts that Node.js runs without a browser."""

from __future__ import annotations

from typing import Any

from tests.web.scene.given.widget_site import in_node

PAGE = """
const texts = new Map();
const own = { enumerable: true, configurable: true, value: "" };
globalThis.localStorage = new Proxy(
  {
    getItem: (key) => texts.get(key) ?? null,
    setItem: (key, value) => void texts.set(key, value),
    removeItem: (key) => void texts.delete(key),
  },
  {
    ownKeys: () => [...texts.keys()],
    getOwnPropertyDescriptor: (_, key) => (texts.has(key) ? own : undefined),
  },
);
const none = { getElementById: () => null, querySelector: () => null, querySelectorAll: () => [] };
const documentElement = { dataset: { cartsSite: "tests", cartsPage: "p" }, lang: "en" };
globalThis.document = Object.assign(new EventTarget(), none, { documentElement });
globalThis.location = { pathname: "/p/", reload() {} };
globalThis.BroadcastChannel = class extends BroadcastChannel {
  constructor(name) {
    super(name);
    this.unref(); // Node.js would wait for messages
  }
};
const refuseTexts = () => {
  globalThis.localStorage = undefined;
};
const load = (name) => import(`${source}/${name}`);
"""


def on_page(script: str, data: object = None) -> Any:
    """What the script gives to `give(value)`, on a page `p` of the site `tests`."""
    return in_node(PAGE + script, data)
