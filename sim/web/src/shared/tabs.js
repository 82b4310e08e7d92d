/** Tabs of one site, and the scripts of one page, tell each other under which keys they have kept something. */

/** @param {import("./storage.js").Opened} store @param {string} site @returns {import("./storage.js").Store} the same, telling and hearing */
export function told(store, site) {
  /** @type {((key: string) => void)[]} */
  const acts = [];
  const channel =
    typeof BroadcastChannel === "function" ? new BroadcastChannel(`carts:${site}`) : null;
  if (channel) {
    channel.onmessage = ({ data }) => {
      for (const act of acts) act(String(data));
    };
  }
  return {
    ...store,
    put: async (key, value, alone) => {
      await store.put(key, value, alone);
      channel?.postMessage(key);
    },
    hear: (act) => void acts.push(act),
  };
}
