"""Browsers that lack something, forbid it or tell it wrongly, and stores in a bad state."""

from __future__ import annotations

from collections.abc import Iterator

from .table import Fault, Must

QUOTA = "throw new DOMException('', 'QuotaExceededError')"
REFUSED = "throw new DOMException('', 'SecurityError')"
SYNC_FULL = f"Storage.prototype.setItem = () => {{ {QUOTA} }}"
NO_STORE = (
    "for (const name of ['indexedDB', 'localStorage'])"
    f" Object.defineProperty(window, name, {{ get() {{ {REFUSED} }} }})"
)
NO_INDEXED = "Object.defineProperty(window, 'indexedDB', { value: undefined })"
# Python's memory is made by the page's worker: there the allocation must fail, not in the page.
WORKER = """const Whole = Blob; window.Blob = class extends Whole {
  constructor(parts, options) { super(["%s;", ...parts], options); } }"""
TOO_LITTLE = (
    "WebAssembly.Memory = function () { throw new RangeError('could not allocate memory') }"
)
LATE = "throw new RangeError('Out of memory')"

LACKS: dict[str, tuple[Must, str]] = {
    "no WebAssembly": ("says", "delete window.WebAssembly"),
    "WebAssembly forbidden": (
        "says",
        "WebAssembly.Module = function () { throw new WebAssembly.CompileError('policy') }",
    ),
    "no memory to compile": (
        "says",
        "WebAssembly.compileStreaming = async () => { throw new RangeError('Out of memory') }",
    ),
    "no memory in the worker": ("says", WORKER % TOO_LITTLE),
    "no memory to instantiate": (
        "says",
        WORKER % f"WebAssembly.instantiate = async () => {{ {LATE} }}",
    ),
    "no workers": ("says", "delete window.Worker"),
    "workers refused": ("says", f"window.Worker = function () {{ {REFUSED} }}"),
    "a worker that breaks": ("says", WORKER % "throw new Error('broken')"),
    "a worker that never answers": ("says", WORKER % "self.postMessage = () => {}"),
    "a worker that dies after its start": (
        "either",
        WORKER % "setTimeout(() => { throw new Error('dead') }, 3000)",
    ),
    "no decompression": ("says", "delete window.DecompressionStream"),
    "no Blob addresses": ("says", f"URL.createObjectURL = () => {{ {REFUSED} }}"),
    "no hashes, as on plain http": (
        "lives",
        "Object.defineProperty(crypto, 'subtle', { value: undefined })",
    ),
    "no native base64": ("lives", "delete Uint8Array.fromBase64"),
    "no random UUID": ("lives", "delete Crypto.prototype.randomUUID"),
    "no ResizeObserver": ("either", "delete window.ResizeObserver"),
    "no IntersectionObserver": ("either", "delete window.IntersectionObserver"),
    "no BroadcastChannel": ("lives", "delete window.BroadcastChannel"),
    "no structuredClone": ("either", "delete window.structuredClone"),
    "no locks": ("lives", "delete Navigator.prototype.locks"),
    "no storage manager": ("lives", "delete Navigator.prototype.storage"),
    "no popover": ("either", "delete HTMLElement.prototype.showPopover"),
    "no view transitions": ("lives", "delete Document.prototype.startViewTransition"),
    "no constructed style sheets": ("either", "delete CSSStyleSheet.prototype.replaceSync"),
    "no Intl": ("either", "delete window.Intl"),
    "no canvas": ("either", "HTMLCanvasElement.prototype.getContext = () => null"),
    "no frames, as in a tab behind": ("either", "window.requestAnimationFrame = () => 0"),
    "no storage at all": ("says", NO_STORE),
    "storage undefined": (
        "says",
        NO_INDEXED + "; Object.defineProperty(window, 'localStorage', { value: null })",
    ),
    "no IndexedDB": ("lives", NO_INDEXED),
    "no localStorage": (
        "lives",
        f"Object.defineProperty(window, 'localStorage', {{ get() {{ {REFUSED} }} }})",
    ),
    "a store that is full": (
        "says",
        f"IDBObjectStore.prototype.put = () => {{ {QUOTA} }}; {SYNC_FULL}",
    ),
    "a store that aborts": (
        "says",
        "const put = IDBObjectStore.prototype.put; IDBObjectStore.prototype.put = function (...a) {"
        " const made = put.apply(this, a); this.transaction.abort(); return made }",
    ),
    "a full localStorage, no IndexedDB": ("says", f"{NO_INDEXED}; {SYNC_FULL}"),
    "a store that never opens": ("says", "indexedDB.open = () => new EventTarget()"),
    "a store that never ends a write": (
        "says",
        "Object.defineProperty(IDBTransaction.prototype, 'oncomplete', { set() {} })",
    ),
    "a store that refuses to open": ("lives", f"indexedDB.open = () => {{ {REFUSED} }}"),
    "a store that refuses to begin": (
        "says",
        f"IDBDatabase.prototype.transaction = () => {{ {REFUSED} }}",
    ),
    "a clock in 1970": ("lives", "const now = Date.now; Date.now = () => now() - 1.795e12"),
    "a clock in 1980": ("lives", "const now = Date.now; Date.now = () => now() - 1.45e12"),
    "a clock in 2080": ("lives", "const now = Date.now; Date.now = () => now() + 1.7e12"),
    "a clock that stands": ("lives", "const at = Date.now(); Date.now = () => at"),
    "a clock that jumps back": ("lives", "let at = Date.now(); Date.now = () => (at -= 60_000)"),
    "a clock of no time": ("lives", "Date.now = () => NaN"),
}

# A visit before has answered; then the browser cannot read it: it is there, or that is said.
UNREAD: dict[str, str] = {
    "earlier answers, whole": "",
    "earlier answers that can't be listed": (
        f"IDBObjectStore.prototype.getAll = () => {{ {REFUSED} }}"
    ),
    "earlier answers that can't be read": (
        "for (const name of ['get', 'getAll', 'getAllKeys'])"
        f" IDBObjectStore.prototype[name] = () => {{ {REFUSED} }}"
    ),
    "earlier answers whose reading fails late": (
        "IDBObjectStore.prototype.getAll = function () { const its = this.get('x');"
        " Promise.resolve().then(() => this.transaction.abort()); return its }"
    ),
    "earlier answers, reading never ends": (
        "IDBObjectStore.prototype.getAll = () => new EventTarget()"
    ),
}

OPEN = """const its = await new Promise((ok, no) => {
    const asked = indexedDB.open("carts:SITE", %s);
    asked.onupgradeneeded = () => { %s }; asked.onsuccess = () => ok(asked.result);
    asked.onerror = () => no(asked.error); });"""
MAKE = 'asked.result.createObjectStore("answers")'
PUT = f"""async () => {{ {OPEN % (1, MAKE)}
  const work = its.transaction("answers", "readwrite");
  for (const id of FIELDS) work.objectStore("answers").put(VALUE, "PAGE#" + id);
  await new Promise((ok) => {{ work.oncomplete = ok; }}); its.close(); }}"""
RECORDS = {
    "a text": '"?"',
    "nothing": "null",
    "a number": "7",
    "a list": "[1, 2, 3]",
    "an answer without a value": "{ id, last: '2026-01-01T00:00:00Z' }",
    "a value of another type": "{ id, type: 'single', value: { a: [1] }, last: 5, earlier: 'no' }",
    "an answer of another version": "{ id, hash: 'old', type: 'text', value: 'older',"
    " last: '2020-01-01T00:00:00Z', tries: 1, first: null }",
    "an answer of the year 9999": "{ id, type: 'text', value: 'later', tries: 1,"
    " first: null, last: '9999-12-31T23:59:59Z' }",
    "an answer of 5 MB": "{ id, type: 'text', value: 'x'.repeat(5e6), last: null, tries: 1 }",
    "a store of a newer version": "",
    "a store without its table": "",
    "bytes": "new Uint8Array(9)",
}
NEWER = f"async () => {{ {OPEN % (2, MAKE)} its.close(); }}"
BARE = f"async () => {{ {OPEN % (1, '')} its.close(); }}"
UNREADABLE_TEXT = """async () => { for (const id of FIELDS)
  localStorage.setItem("carts:SITE:PAGE#" + id, "{cut"); }"""


def of_browsers() -> Iterator[Fault]:
    """What Chromium is told to lack."""
    for name, (must, script) in LACKS.items():
        yield Fault(name, must, without=script)
    for name, script in UNREAD.items():
        yield Fault(name, "either", without=script, earlier=True)
    for name, value in RECORDS.items():
        before = NEWER if "newer" in name else BARE if "table" in name else PUT
        seen: Must = "either" if "table" in name else "lives"
        yield Fault(f"kept before: {name}", seen, before=before.replace("VALUE", value or "0"))
    name = "kept before: a text cut short, no IndexedDB"
    yield Fault(name, "either", without=NO_INDEXED, before=UNREADABLE_TEXT)
