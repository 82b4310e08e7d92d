/**
 * What a reader did in one place of a page, kept under its id with the answers: a prediction, a law, what
 * was tried or found. Questions, of which a page has many, have a book of their own (answers/book.js).
 */

import { openStore, place } from "./storage.js";

export class Kept {
  #key = "";
  /** @type {Promise<import("./storage.js").Store>} */
  #store;

  /** @param {string} id */
  constructor(id) {
    const { site, page } = place();
    this.#key = `${page}#${id}`;
    this.#store = openStore(site);
  }

  /** Whether the browser keeps it beyond this visit. */
  async lasts() {
    return (await this.#store).kind === "kept";
  }

  /** Whether it stands under a code word. */
  async named() {
    return (await this.#store).student !== "";
  }

  /** What is kept; null: nothing, or it cannot be read. @returns {Promise<any>} */
  async get() {
    const store = await this.#store;
    return (await store.get(this.#key).catch(() => null)) ?? null;
  }

  /** Resolves when the browser says that it is kept, rejects when it refuses. @param {object} entry */
  async put(entry) {
    await (await this.#store).put(this.#key, entry);
    document.dispatchEvent(new CustomEvent("carts-kept", { detail: this.#key }));
  }

  async forget() {
    await (await this.#store).remove(this.#key);
    document.dispatchEvent(new CustomEvent("carts-forgotten", { detail: this.#key }));
  }

  /** From now on. @param {(found: any) => void} act what to do with what another tab has kept here; null: it has forgotten it @param {AbortSignal} signal until then */
  async hear(act, signal) {
    (await this.#store).hear(async (key, gone) => {
      if (key !== this.#key) return;
      const found = await this.get();
      if (found || gone) act(found); // kept, but not to be read yet: that is not forgotten
    }, signal);
  }
}
