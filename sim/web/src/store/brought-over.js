/**
 * What a visit kept as text, because IndexedDB did not open then: the next one at which it opens takes it
 * over. Nobody else would ever look for it, and what was answered in that visit would seem lost.
 */

import { merged } from "../answers/entry.js";
import { STUDENT } from "../shared/code-word.js";
import { BROWSER, recall, retain } from "../shared/tab.js";
import { keptAsText } from "./text-store.js";

/** @typedef {import("./storage.js").Opened} Opened */

const PATIENCE = 5000; // ms that a page waits for what an earlier visit kept; it comes all the same

/** A mark beside what is kept as text: this browser has a database of the site, and who works in it. @param {string} site */
const marked = (site) => `carts-database:${site}`;

/** Into the database with what was kept as text. @param {Opened} store the database @param {string} site */
export async function takeTexts(store, site) {
  void remember(store, site); // no page waits for it
  const texts = keptAsText(site);
  const found = await texts.entries().catch(() => []); // a browser that lets nobody look has kept nothing
  if (found.length === 0) return;
  // One tab, or one script of this page, at a time: the second finds nothing left.
  const take = () => takeOver(store, texts).catch(() => {}); // what is refused stays where it is
  const taken = Promise.resolve(navigator.locks?.request(`carts-texts:${site}`, take) ?? take());
  const late = new Promise((resolve) => setTimeout(resolve, PATIENCE));
  await Promise.race([taken.catch(take), late]);
}

/** @param {Opened} store @param {string} site */
async function remember(store, site) {
  const { code = "" } = (await store.get(STUDENT).catch(() => null)) ?? {};
  if (recall(marked(site), BROWSER)?.code !== code) retain(marked(site), { code }, BROWSER);
}

/**
 * The store as text, while the database does not open: it says so (`behind`), and who works here is who
 * worked here before. @param {Opened} texts @param {string} site @returns {Promise<Opened>}
 */
export async function instead(texts, site) {
  const before = recall(marked(site), BROWSER);
  if (!before) return texts;
  if (before.code && !(await texts.get(STUDENT))) {
    await texts.put(STUDENT, { code: before.code, last: "" }).catch(() => {});
  }
  return { ...texts, behind: true };
}

/** @param {Opened} store @param {Opened} texts */
async function takeOver(store, texts) {
  for (const [key, text] of await texts.entries()) {
    if (text === null) continue; // cut short: nothing can be read of it
    const value = both(await store.get(key), text);
    if (value === null) continue;
    await store.put(key, value); // not blindly: another tab may have kept something since
    await texts.remove(key);
  }
}

/** What of the two is kept; null: nobody can tell, so both stay where they are. @param {any} kept @param {any} text */
function both(kept, text) {
  if (kept === undefined || kept === null) return text;
  if ("type" in Object(kept) && "type" in Object(text)) return merged(kept, text); // two answers
  if (!("last" in Object(kept) && "last" in Object(text))) return null; // readings of real carts
  return String(kept.last) > String(text.last) ? kept : text;
}
