"""Keys and values of a store are of one moment, whatever another tab writes meanwhile."""

from __future__ import annotations

from tests.web.scene.given.widget_site import in_node

SCRIPT = """
const kept = new Map([["b", 2], ["c", 3]]);
const asking = (result) => {
  const request = { result };
  setTimeout(() => request.onsuccess());
  return request;
};
let begun = 0;
const base = {
  transaction() {
    begun += 1;
    if (begun === 2) kept.set("a", 1); // another tab, between two transactions
    const now = [...kept].sort();
    return {
      objectStore: () => ({
        getAllKeys: () => asking(now.map(([key]) => key)),
        getAll: () => asking(now.map(([, value]) => value)),
      }),
    };
  },
};
globalThis.indexedDB = { open: () => asking(base) };
const { indexed } = await import(`${source}/store/indexed-store.js`);
give(await (await indexed("carts:tests")).entries());
"""


def test_every_value_is_read_with_its_own_key_while_another_tab_writes() -> None:
    assert in_node(SCRIPT, None) == [["b", 2], ["c", 3]]
