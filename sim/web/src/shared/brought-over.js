/**
 * What a visit kept as text, because IndexedDB did not open then: the next one at which it opens takes it
 * over. Nobody else would ever look for it, and what was answered in that visit would seem lost.
 */

import { merged } from "../answers/entry.js";
import { BROWSER, recall, retain } from "./tab.js";
import { textStore } from "./text-store.js";

/** @typedef {import("./storage.js").Opened} Opened */

/** A mark beside what is kept as text: this browser has a database of the site. @param {string} site */
const marked = (site) => `carts-database:${site}`;

/** @param {Opened} store IndexedDB @param {string} site @returns {Promise<Opened>} the same, with what was kept as text */
export async function withTexts(store, site) {
  const texts = textStore(site);
  if (!texts) return store;
  retain(marked(site), true, BROWSER);
  if ((await texts.entries()).length === 0) return store;
  // One tab, or one script of this page, at a time: the second finds nothing left.
  const locks = globalThis.navigator?.locks;
  const take = () => takeOver(store, texts);
  await (locks ? locks.request(`carts-texts:${site}`, take) : take()).catch(() => {});
  return store;
}

/** Whether what this browser kept of the site before lies in a database that does not open now. @param {string} site */
export function hasDatabase(site) {
  return recall(marked(site), BROWSER) === true;
}

/** @param {Opened} store @param {Opened} texts */
async function takeOver(store, texts) {
  for (const [key, text] of await texts.entries()) {
    if (text === null) continue; // cut short: nothing can be read of it
    await store.put(key, both(await store.get(key), text), true);
    await texts.remove(key); // what is refused stays where it is
  }
}

/** @param {any} kept @param {any} text */
function both(kept, text) {
  if (kept === undefined || kept === null) return text;
  if ("type" in Object(kept) && "type" in Object(text)) return merged(kept, text); // two answers
  return String(kept.last ?? "") > String(text.last ?? "") ? kept : text;
}
