/** What was tried for a challenge, kept with the answers of its lesson: a teacher sees how the class has looked. */

import { outline } from "../answers/outline.js";
import { openStore, place } from "../shared/storage.js";

const TYPE = "challenge";

/** @typedef {{runs: number, found: number, values: string}} Tried `found`: in which run; 0: in none. `values`: what was set there, in words */

/** @param {string} id of the challenge */
const keyOf = (id) => `${place().page}#${id}`;

/** What was tried at earlier visits; null: nothing. @param {string} id @returns {Promise<Tried | null>} */
export async function triedBefore(id) {
  const store = await openStore(place().site);
  const entry = await store.get(keyOf(id)).catch(() => null);
  const { runs, found, values } = (entry?.type === TYPE && entry.value) || {};
  if (!Number.isInteger(runs)) return null;
  return { runs, found: Number.isInteger(found) ? found : 0, values: String(values ?? "") };
}

/** @param {string} id @param {string} asked @param {Tried} tried @param {string} said the same in words */
export async function keepTried(id, asked, tried, said) {
  if (!outline()) return; // a page that is no lesson has no answers
  const now = new Date().toISOString();
  try {
    const store = await openStore(place().site);
    const before = await store.get(keyOf(id)).catch(() => null);
    await store.put(keyOf(id), {
      id,
      type: TYPE,
      value: tried,
      first: before?.first ?? now,
      last: now,
      tries: tried.runs,
      locked: null,
      asked,
      said,
    });
    document.dispatchEvent(new Event("carts-kept"));
  } catch {
    // It is counted on the page all the same.
  }
}
