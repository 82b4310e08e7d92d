/** What was tried for a challenge, kept with the answers of its lesson: a teacher sees how the class has looked. */

import { outline } from "../answers/outline.js";
import { keepOnPage, keptOnPage } from "../shared/kept.js";

const TYPE = "challenge";

/** @typedef {{runs: number, found: number, values: string}} Tried `found`: in which run; 0: in none. `values`: what was set there, in words */

/** What was tried at earlier visits; null: nothing. @param {string} id @returns {Promise<Tried | null>} */
export async function triedBefore(id) {
  const entry = await keptOnPage(id);
  const { runs, found, values } = (entry?.type === TYPE && entry.value) || {};
  if (!Number.isInteger(runs)) return null;
  return { runs, found: Number.isInteger(found) ? found : 0, values: String(values ?? "") };
}

/** @param {string} id @param {string} asked @param {Tried} tried @param {string} said the same in words */
export async function keepTried(id, asked, tried, said) {
  if (!outline()) return; // a page that is no lesson has no answers
  const now = new Date().toISOString();
  const before = await keptOnPage(id);
  const first = before?.first ?? now;
  await keepOnPage({
    id,
    type: TYPE,
    value: tried,
    first,
    last: now,
    tries: tried.runs,
    asked,
    said,
  });
}
