/** What a browser refuses to keep, or all where it keeps nothing: there until the page closes. */

import { keepEarlier } from "../answers/entry.js";

/** @typedef {import("./storage.js").Store} Store */

/**
 * What a browser refuses to keep, as long as the page is open: it can still be saved as a file. The
 * scripts of a page share it.
 * @returns {Map<string, any>}
 */
function shelter() {
  const page = /** @type {any} */ (globalThis);
  const name = Symbol.for("carts-shelter");
  page[name] ??= new Map();
  return page[name];
}

/** The same store, and what it refused. @param {Store} store @returns {Store} */
export function sheltered(store) {
  return {
    ...store,
    put: async (key, value, alone) => {
      try {
        await store.put(key, value, alone);
        shelter().delete(key);
      } catch (error) {
        shelter().set(key, keepEarlier(shelter().get(key), value));
        throw error;
      }
    },
    remove: async (key) => {
      shelter().delete(key);
      await store.remove(key);
    },
    entries: async () => [...new Map([...(await store.entries()), ...shelter()])],
  };
}

/** @returns {Store} */
export function memory() {
  const kept = shelter();
  return {
    kind: "memory",
    how: "memory",
    get: async (key) => kept.get(key),
    put: async (key, value) => void kept.set(key, keepEarlier(kept.get(key), value)),
    remove: async (key) => void kept.delete(key),
    entries: async () => [...kept],
  };
}
