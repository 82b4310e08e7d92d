/** What a reader did on a page that is no answer to a question: kept with the answers all the same. */

import { openStore, place } from "./storage.js";

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
