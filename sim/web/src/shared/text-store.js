/** The store in localStorage, for browsers whose IndexedDB is closed: each value as text under its key. */

import { keepEarlier } from "../answers/entry.js";

/** @typedef {import("./storage.js").Opened} Opened */

/** @param {string} site @returns {Opened | null} */
export function textStore(site) {
  const before = `carts:${site}:`;
  try {
    localStorage.setItem(`${before}probe`, "1");
    localStorage.removeItem(`${before}probe`);
  } catch {
    return null;
  }
  const get = (/** @type {string} */ key) => {
    try {
      return JSON.parse(localStorage.getItem(before + key) ?? "null");
    } catch {
      return null; // cut short: it hides none of the others
    }
  };
  return {
    kind: "kept",
    how: "text",
    get: async (key) => get(key),
    put: async (key, value) =>
      localStorage.setItem(before + key, JSON.stringify(keepEarlier(get(key), value))),
    remove: async (key) => localStorage.removeItem(before + key),
    entries: async () =>
      Object.keys(localStorage)
        .filter((name) => name.startsWith(before))
        .map((name) => [name.slice(before.length), get(name.slice(before.length))]),
  };
}
