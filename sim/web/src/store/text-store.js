/** The store in localStorage, for browsers whose IndexedDB is closed: each value as text under its key. */

import { keepEarlier } from "../answers/entry.js";

/** @typedef {import("./storage.js").Opened} Opened */

const beginning = (/** @type {string} */ site) => `carts:${site}:`;

/** Null: this browser lets nothing be kept so, or there is no room. @param {string} site @returns {Opened | null} */
export function textStore(site) {
  try {
    localStorage.setItem(`${beginning(site)}probe`, "1");
    localStorage.removeItem(`${beginning(site)}probe`);
  } catch {
    return null;
  }
  return keptAsText(site);
}

/** What was kept so before, even where there is no room for more. Throws where it may not be read. @param {string} site @returns {Opened} */
export function keptAsText(site) {
  const before = beginning(site);
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
