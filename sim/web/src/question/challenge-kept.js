/** What was tried for a challenge, kept with the answers of its lesson: a teacher sees how the class has looked. */

import { outline } from "../answers/outline.js";
import { Kept } from "../store/kept.js";

const TYPE = "challenge";

/** @typedef {{runs: number, found: number, values: string}} Tried `found`: in which run; 0: in none. `values`: what was set there, in words */

/** @param {string} id of the challenge */
export function triedKeeper(id) {
  const kept = new Kept(id);
  return {
    /** @param {() => void} act what to do when another tab has kept more @param {AbortSignal} signal until then */
    hear: (act, signal) => void kept.hear(act, signal),
    /** What was tried at earlier visits; null: nothing. @returns {Promise<Tried | null>} */
    async get() {
      const entry = await kept.get();
      const { runs, found, values } = (entry?.type === TYPE && entry.value) || {};
      if (!Number.isInteger(runs)) return null;
      return { runs, found: Number.isInteger(found) ? found : 0, values: String(values ?? "") };
    },
    /** @param {string} asked @param {Tried} tried @param {string} said the same in words */
    async put(asked, tried, said) {
      if (!outline()) return; // a page that is no lesson has no answers
      const now = new Date().toISOString();
      const first = (await kept.get())?.first ?? now;
      const entry = { id, type: TYPE, value: tried, first, last: now, tries: tried.runs };
      await kept.put({ ...entry, asked, said }).catch(() => {}); // refused: this tab knows it all the same
    },
  };
}
