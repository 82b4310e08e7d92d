/** What a reader did on a page that is no answer to a question: kept with the answers all the same. */

import { openStore, place } from "./storage.js";

/** What is kept of it, or null. @param {string} id @returns {Promise<any>} */
export async function keptOnPage(id) {
  const { site, page } = place();
  const store = await openStore(site);
  return store.get(`${page}#${id}`).catch(() => null);
}

/** Calls when another tab has kept it. @param {string} id @param {() => void} act */
export async function hearOnPage(id, act) {
  const { site, page } = place();
  (await openStore(site)).hear((key) => key === `${page}#${id}` && act());
}

/** Where the browser refuses it the page goes on; at the next visit it has to be done again. @param {{id: string} & Record<string, unknown>} entry */
export async function keepOnPage(entry) {
  const { site, page } = place();
  try {
    const store = await openStore(site);
    await store.put(`${page}#${entry.id}`, { locked: null, ...entry });
    document.dispatchEvent(new Event("carts-kept"));
  } catch {
    // as above
  }
}
