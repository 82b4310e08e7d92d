"""A page goes on hearing that Python lives when the clock of the computer is set back."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
let [day, passed] = [1e12, 5000];
Date.now = () => day;
performance.now = () => passed;
const told = [];
let alive;
const python = {
  _api: { config: {} },
  runPython: () => 1,
  toPy: (given) => ({ alive } = given),
  pyimport: () => ({ destroy() {}, answer: () => [] }),
};
globalThis.self = {
  addEventListener() {},
  postMessage: (message) => told.push(message),
  __pyodide: { loadPyodide: async () => python },
};
await import(`${source}/runtime/worker.js`);
self.onmessage({ data: { do: "boot", lock: {}, snapshot: false, load: [], modules: [] } });
const table = { do: "file", name: "python.zip", bytes: new ArrayBuffer(100) };
self.onmessage({ data: table });
await new Promise((done) => setTimeout(done, 50));
const counted = () => told.filter(({ stage }) => stage === "packages").length;
const before = counted();
alive();
const first = counted() - before;
day -= 3_600_000;
passed += 2000;
alive();
alive();
give([first, counted() - before]);
"""


def test_a_sign_of_life_is_told_once_a_second() -> None:
    assert in_node(SCRIPT, None) == [1, 2]
