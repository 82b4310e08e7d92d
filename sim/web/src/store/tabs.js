/** Tabs of one site, and the scripts of one page, tell each other under which keys they have kept or forgotten something. */

/** @param {import("./storage.js").Opened} store @param {string} site @returns {import("./storage.js").Store} the same, telling and hearing */
export function telling(store, site) {
  const channel = channelOf(`carts:${site}`);
  return {
    ...store,
    student: "",
    put: async (key, value, alone) => {
      await store.put(key, value, alone);
      channel?.postMessage({ key, gone: false });
    },
    remove: async (key) => {
      await store.remove(key);
      channel?.postMessage({ key, gone: true });
    },
    hear: (act, signal) => {
      channel?.addEventListener(
        "message",
        ({ data }) => act(String(data.key), data.gone),
        signal && { signal },
      );
    },
  };
}

/** @param {string} name @returns {BroadcastChannel | null} null: there are none, or Firefox refuses them, as it does where all cookies are blocked */
function channelOf(name) {
  try {
    return new BroadcastChannel(name);
  } catch {
    return null;
  }
}
