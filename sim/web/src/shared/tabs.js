/** Tabs of one site, and the scripts of one page, tell each other under which keys they have kept something. */

/** @param {import("./storage.js").Opened} store @param {string} site @returns {import("./storage.js").Store} the same, telling and hearing */
export function telling(store, site) {
  const channel = globalThis.BroadcastChannel && new BroadcastChannel(`carts:${site}`);
  return {
    ...store,
    put: async (key, value, alone) => {
      await store.put(key, value, alone);
      channel?.postMessage(key);
    },
    hear: (act) => channel?.addEventListener("message", ({ data }) => act(String(data))),
  };
}
