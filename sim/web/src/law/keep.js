/** The text of a law is an answer like any other: kept at every input, in the answer file, on paper. */

import { setAside } from "../answers/entry.js";
import { isCurrent } from "../answers/outline.js";
import { Kept } from "../store/kept.js";

/** @param {{id: string, hash: string, ask: string}} facts */
export function lawKeeper({ id, hash, ask }) {
  const kept = new Kept(id);
  /** @type {any} */
  let entry = { id, hash, type: "law", value: null, first: null, last: null, tries: 0 };
  /** Goes on from what is kept. @param {any} found @returns {string | null} its text */
  const taken = (found) => {
    if (found?.type !== "law" || typeof found.value !== "string") return null;
    if (isCurrent(found)) entry = found;
    return found.value;
  };
  return {
    /** @param {(text: string) => void} act what to do with a text that another tab keeps @param {AbortSignal} signal until then */
    hear(act, signal) {
      const heard = (/** @type {any} */ found) => {
        const text = taken(found);
        if (text !== null) act(text);
      };
      void kept.hear(heard, signal);
    },
    /** @returns {Promise<string | null>} what was written here before */
    get: async () => taken(await kept.get()),
    /** The text goes to the earlier ones: another is about to take its place. */
    setAside() {
      entry = setAside(entry);
    },
    /** @param {string} text @param {boolean} tried whether it was run @returns {Promise<boolean>} whether the browser says that it is kept */
    async put(text, tried = false) {
      const now = new Date().toISOString();
      const tries = (entry.tries ?? 0) + (tried ? 1 : 0);
      entry = { ...entry, hash, value: text, said: text, asked: ask.slice(0, 300), tries };
      entry = { ...entry, first: entry.first ?? now, last: now };
      try {
        await kept.put(entry);
        return await kept.lasts();
      } catch {
        return false;
      }
    },
  };
}
