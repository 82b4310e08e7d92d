/** The text of a law is an answer like any other: kept at every input, in the answer file, on paper. */

import { setAside } from "../answers/entry.js";
import { isCurrent } from "../answers/outline.js";
import { openStore, place } from "../shared/storage.js";

/** @param {{id: string, hash: string, ask: string}} facts @param {(text: string) => void} elsewhere what to do with a text that another tab keeps */
export function lawKeeper({ id, hash, ask }, elsewhere) {
  const { site, page } = place();
  const key = `${page}#${id}`;
  const opened = openStore(site);
  /** @type {any} */
  let entry = { id, hash, type: "law", value: null, first: null, last: null, tries: 0 };
  const get = async () => {
    const found = await (await opened).get(key).catch(() => null);
    if (found?.type !== "law" || typeof found.value !== "string") return null;
    if (isCurrent(found)) entry = found;
    return found.value;
  };
  void opened.then((store) =>
    store.hear(async (told) => {
      const text = told === key ? await get() : null;
      if (text !== null) elsewhere(text);
    }),
  );
  return {
    /** @returns {Promise<string | null>} what was written here before */
    get,
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
        const store = await opened;
        await store.put(key, entry);
        document.dispatchEvent(new Event("carts-kept"));
        return store.kind === "kept";
      } catch {
        return false;
      }
    },
  };
}
