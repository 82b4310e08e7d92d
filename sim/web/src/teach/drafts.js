/**
 * Drafts of a lesson, kept in this browser in a store of their own, apart from answers. A draft belongs to
 * the version of the lesson that it began from (`hash`): when the lesson is published anew, the older draft
 * is still there and is offered.
 */

import { openAll, place } from "../shared/storage.js";

/** @typedef {{text: string, base: string, last: string, hash: string}} Draft `base`: what it began from */

export class Drafts {
  /** @param {import("./source.js").Told} told */
  constructor(told) {
    const { site, page } = place();
    this.hash = told.hash;
    this.before = `${page}#`;
    this.store = openAll(`${site}~teacher`);
  }

  /** @returns {Promise<Draft | null>} of this version of the lesson */
  async current() {
    const found = await (await this.store).get(this.before + this.hash).catch(() => null);
    return isDraft(found) ? found : null;
  }

  /** @returns {Promise<Draft[]>} of earlier versions, the newest first */
  async earlier() {
    const all = await (await this.store).entries().catch(() => []);
    return all
      .filter(([key, value]) => key.startsWith(this.before) && isDraft(value))
      .map(([, value]) => /** @type {Draft} */ (value))
      .filter((draft) => draft.hash !== this.hash)
      .sort((a, b) => (a.last < b.last ? 1 : -1));
  }

  /** Resolves with whether the browser keeps it beyond this visit. @param {string} text @param {string} base */
  async keep(text, base) {
    const store = await this.store;
    const draft = { text, base, last: new Date().toISOString(), hash: this.hash };
    await store.put(this.before + this.hash, draft, true);
    return store.kind === "kept";
  }

  /** @param {string} hash */
  async forget(hash = this.hash) {
    await (await this.store).remove(this.before + hash);
  }
}

/** @param {any} value @returns {value is Draft} */
function isDraft(value) {
  return typeof value?.text === "string" && typeof value?.base === "string";
}
