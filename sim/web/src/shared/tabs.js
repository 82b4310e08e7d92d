/** Tabs of one site, and the scripts of one page, tell each other under which keys they have kept or forgotten something. */

/** @param {import("./storage.js").Opened} store @param {string} site @returns {import("./storage.js").Store} the same, telling and hearing */
export function telling(store, site) {
  const channel = globalThis.BroadcastChannel && new BroadcastChannel(`carts:${site}`);
  return {
    ...store,
    put: async (key, value, alone) => {
      await store.put(key, value, alone);
      channel?.postMessage({ key, gone: false });
    },
    remove: async (key) => {
      await store.remove(key);
      channel?.postMessage({ key, gone: true });
    },
    hear: (act) => {
      channel?.addEventListener("message", ({ data }) => act(String(data.key), data.gone));
    },
  };
}
