/** What a browser refuses to keep, or all where it keeps nothing: there until the page closes. */

import { keepEarlier } from "../answers/entry.js";

/** @typedef {import("./storage.js").Opened} Opened */

/**
 * What a browser refuses to keep, as long as the page is open: it can still be saved as a file. The
 * scripts of a page share it; answers, readings and drafts are apart, as in the browser.
 * @param {string} site @returns {Map<string, any>}
 */
function shelter(site) {
  const page = /** @type {any} */ (globalThis);
  const name = Symbol.for(`carts-shelter:${site}`);
  page[name] ??= new Map();
  return page[name];
}

/** The same store, and what it refused. @param {Opened} store @param {string} site @returns {Opened} */
export function sheltered(store, site) {
  const refused = shelter(site);
  return {
    ...store,
    put: async (key, value, alone) => {
      try {
        await store.put(key, value, alone);
        refused.delete(key);
      } catch (error) {
        refused.set(key, keepEarlier(refused.get(key), value));
        throw error;
      }
    },
    remove: async (key) => {
      refused.delete(key);
      await store.remove(key);
    },
    entries: async () => [...new Map([...(await store.entries()), ...refused])],
  };
}

/** @param {string} site @returns {Opened} */
export function memory(site) {
  const kept = shelter(site);
  return {
    kind: "memory",
    how: "memory",
    get: async (key) => kept.get(key),
    put: async (key, value) => void kept.set(key, keepEarlier(kept.get(key), value)),
    remove: async (key) => void kept.delete(key),
    entries: async () => [...kept],
  };
}
