"""A teacher at work in a document of linkedom, before a Python that answers when it is told to.

Its looks are simple: every paragraph is a piece; `key: value` lines of a paragraph that begins with
`# block` are its fields. The script has `session`, `client`, and what it needs to type and to
answer.
"""

from __future__ import annotations

from typing import Any

from tests.web.scene.given.widget_site import in_node

PAGE = """<!doctype html><html><body><article class="md-content__inner"><h1>T</h1>\
<p class="carts-teach-door"><a href="#teacher">Change</a></p></article></body></html>"""

SCRIPT = """
const { parseHTML } = await import("linkedom");
const window = parseHTML(data.page);
globalThis.window = window;
globalThis.document = window.document;
window.HTMLElement.prototype.setSelectionRange = () => {};
window.HTMLElement.prototype.scrollIntoView = () => {};
globalThis.customElements = { get: () => true };
globalThis.self = globalThis;
globalThis.BroadcastChannel = class extends BroadcastChannel {
  constructor(name) {
    super(name);
    this.unref(); // Node.js would wait for messages
  }
};
const later = setTimeout;
globalThis.setTimeout = (act, ms, ...more) => {
  const timer = later(act, ms, ...more);
  if (ms > 5000) timer.unref(); // Node.js would wait for it
  return timer;
};
globalThis.scrollTo = globalThis.addEventListener = () => {};
globalThis.location = { pathname: "/p/", href: "file:///p/" };
globalThis.Option = function Option(text) {
  const made = document.createElement("option");
  made.textContent = text;
  return made;
};
const { Client } = await import(`${source}/runtime/client.js`);
const { Session } = await import(`${source}/teach/session.js`);
const { hashOf, KEPT_OUT } = await import(`${source}/teach/source.js`);

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
/** Some time, and what checksums that were asked for by then bring about: they come from threads of
 * their own, which are late on a busy machine. */
const turn = async (ms = 0) => {
  await pause(ms);
  for (let k = 0; k < 3; k++) {
    await crypto.subtle.digest("SHA-256", new Uint8Array());
    await pause(0);
  }
};
const fieldsOf = (text) =>
  !text.startsWith("# block")
    ? []
    : [...text.matchAll(/^(\\w+): (.*)$/gm)].map(([, label, value]) => ({
        ...{ path: [label], group: "", label, kind: "line", value, place: [0, 0], options: [] },
      }));
const piecesOf = (text) =>
  text.split(/(?<=\\n\\n)/).map((piece) => ({
    ...{ kind: piece.startsWith("# block") ? "block" : "text", text: piece, line: 1 },
    ...{ name: "scene", id: "", title: "", fields: fieldsOf(piece) },
  }));
const ways = {
  look: ({ text }) => {
    const pieces = piecesOf(text);
    const blocks = pieces.filter(({ kind }) => kind === "block");
    return {
      ...{ pieces, findings: [], frame: `<h1>${text}</h1>`, more: false, needs: [] },
      blocks: blocks.map((block) => ({ state: "shown", key: block.text, html: "<p></p>" })),
    };
  },
  set: ({ text, path, value }) =>
    value.includes("!")
      ? { refused: "This cannot be written." }
      : { text: text.replace(new RegExp(`^${path[0]}: .*$`, "m"), `${path[0]}: ${value}`) },
  restore: ({ text, own }) => {
    const note = /^note: (.*)$/m.exec(own)?.[1];
    return { text: note ? text.replace(KEPT_OUT, note) : text, missing: note ? 0 : 1 };
  },
  zip: ({ text }) => ({ base64: btoa(text) }),
};

/** What was asked of Python and is not answered yet. */
const asked = [];
let holds = () => false;
const answer = () => {
  const { message, resolve } = asked.shift();
  resolve({ header: structuredClone(ways[message.do](message)), numbers: [] });
};
const runtime = {
  request: (message) =>
    new Promise((resolve) => {
      asked.push({ message, resolve });
      if (!holds(message)) setTimeout(answer);
    }),
  stop: () => {},
};
let start = async () => runtime;
const client = new Client((more) => start(more));

/** Drafts of a browser. */
const kept = new Map();
globalThis.localStorage = undefined;
const { Drafts } = await import(`${source}/teach/drafts.js`);
const { place } = await import(`${source}/store/storage.js`);
const stored = {
  ...{ kind: "kept", get: async (key) => kept.get(key) },
  put: async (key, value) => void kept.set(key, value),
  remove: async (key) => void kept.delete(key),
  entries: async () => [...kept],
  hear: (act) => void hearing.push(act),
};
const hearing = [];
/** Another tab keeps a draft. */
const otherKeeps = async (key, draft) => {
  kept.set(key, draft);
  for (const hear of hearing) await hear(key, false);
};
const page = () => place().page;

/** Files that the page gave away: their names and texts. */
const files = [];
URL.createObjectURL = (blob) => {
  files.push(blob);
  return "blob:";
};
URL.revokeObjectURL = () => {};

let session;
/** A session; `text` null: the teacher opens the file. */
async function begin(text, hash = "published") {
  const told = { file: "docs/a.md", text, hash, files: {}, lesson: { file: "docs/a.md" } };
  const drafts = new Drafts(told);
  drafts.store = Promise.resolve(stored);
  const link = document.querySelector(".carts-teach-door a");
  session = new Session({ told, client, assets: "file:///a/", drafts, link });
  session.page.show = async () => {};
  session.page.adopt = (look) => adopted.push(look.pieces.map((piece) => piece.text).join(""));
  return session;
}
const adopted = [];
const one = (selector) => session.panel.root.querySelector(selector);
const all = (selector) => [...session.panel.root.querySelectorAll(selector)];
const status = () => one(".carts-teach-status").textContent;
const open = () => {
  for (const piece of all(".carts-teach-piece")) {
    piece.open = true;
    piece.dispatchEvent(new window.Event("toggle"));
  }
};
const type = (control, value) => {
  control.value = value;
  control.dispatchEvent(new window.Event("input"));
};
const press = (name) => one(name).dispatchEvent(new window.Event("click"));
const choose = async (text, name = "a.md") => {
  const input = one(".carts-teach-own input");
  const bytes = new TextEncoder().encode(text);
  const file = { name, arrayBuffer: async () => bytes };
  Object.defineProperty(input, "files", { value: [file], configurable: true });
  input.dispatchEvent(new window.Event("change"));
  await turn(60);
};
const given = async () => await files.at(-1)?.text();
"""


def at_work(script: str, **data: Any) -> Any:
    """What the script gives to `give(value)`."""
    return in_node(SCRIPT + script, {"page": PAGE, **data})
