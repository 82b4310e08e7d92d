/**
 * Drafts of a lesson, kept in this browser in a store of their own, apart from answers. A draft belongs to
 * the version of the lesson that it began from (`hash`): when the lesson is published anew, the older draft
 * is still there and is offered. Of two tabs, each keeps a draft of its own: the newest comes back, others are
 * offered.
 */

import { BROWSER, recallOnce, retain } from "../shared/tab.js";
import { openAll, place } from "../store/storage.js";
import { draftMark } from "./door.js";

/** @typedef {{text: string, base: string, last: string, hash: string}} Kept `base`: what it began from */
/** @typedef {Kept & {key: string}} Draft where it is kept */

export class Drafts {
  /** @param {import("./source.js").Told} told */
  constructor(told) {
    const { site, page } = place();
    this.hash = told.hash;
    this.before = `${page}#`;
    this.key = this.before + this.hash;
    /** @type {string | null} the teacher's file, where the site has no text of the lesson */
    this.own = null;
    /** @type {Kept | null} what this tab kept last */
    this.kept = null;
    this.store = openAll(`${site}~teacher`);
  }

  /** @returns {Promise<Draft[]>} the newest first */
  async #all() {
    const all = await (await this.store).entries().catch(() => []);
    return all
      .filter(([key, value]) => key.startsWith(this.before) && isDraft(value))
      .map(([key, value]) => ({ .../** @type {Kept} */ (value), key }))
      .sort((a, b) => (a.last < b.last ? 1 : -1));
  }

  /** @returns {Promise<{draft: Draft | null, earlier: Draft[]}>} of this version of the lesson, and all others */
  async found() {
    const all = await this.#all();
    const draft = all.find(({ hash }) => hash === this.hash) ?? null;
    this.key = draft?.key ?? this.key;
    return { draft, earlier: all.filter((one) => one !== draft) };
  }

  /**
   * Of a lesson whose text is not in the site: a draft belongs to the file that it began from, and is brought
   * back to no other. Drafts hold what the page must not show, such as the words that open a test: whoever
   * opens another file is told nothing of them.
   * @param {string} own the file's text @param {string} hash of it
   * @returns {Promise<{draft: Draft | null, earlier: Draft[]}>}
   */
  async ofFile(own, hash) {
    const published = hash !== "" && hash === this.hash;
    const found = await this.#all();
    const draft =
      found.find(({ base }) => base === own) ??
      found.find((one) => published && one.hash === hash) ??
      null;
    this.hash = draft?.hash ?? (hash || sumOf(own));
    this.key = draft?.key ?? this.before + this.hash; // what is kept now leaves the others as they are
    this.own = own;
    return { draft, earlier: found.filter((one) => one !== draft && holds(own, one)) };
  }

  /** Resolves with whether the browser keeps it beyond this visit. @param {string} text @param {string} base */
  async keep(text, base) {
    const store = await this.store;
    this.kept = { text, base, last: new Date().toISOString(), hash: this.hash };
    await store.put(this.key, this.kept, true);
    if (this.own === null) retain(draftMark(), true, BROWSER); // of a test nobody else is told
    return store.kind === "kept";
  }

  /**
   * Another tab that keeps a draft where this one does has that place: what this tab kept there, and keeps from
   * now on, goes to a place of its own. @param {(draft: Draft) => void} act with the other's, once for each place: it is kept up to date
   */
  async hear(act) {
    const store = await this.store;
    /** @type {Map<string, Draft>} */
    const others = new Map();
    store.hear(async (key, gone) => {
      if (gone || (key !== this.key && !others.has(key))) return;
      if (key === this.key) {
        this.key = `${this.before}${this.hash}~${Math.random().toString(36).slice(2)}`;
        if (this.kept) await store.put(this.key, this.kept, true).catch(() => {});
      }
      const found = await store.get(key).catch(() => null);
      if (!isDraft(found) || (this.own !== null && !holds(this.own, found))) return;
      const known = others.get(key);
      if (known) return void Object.assign(known, found);
      const draft = { ...found, key };
      others.set(key, draft);
      act(draft);
    });
  }

  async forget(key = this.key) {
    if (key === this.key) this.kept = null;
    await (await this.store).remove(key);
    if (this.own === null && !(await this.#all()).length) recallOnce(draftMark(), BROWSER);
  }
}

/** A name for a text where the browser has no sha256. @param {string} text */
function sumOf(text) {
  let sum = 7;
  for (const sign of text) sum = (Math.imul(sum, 31) + Number(sign.codePointAt(0))) >>> 0;
  return `${text.length}-${sum.toString(16)}`;
}

/** @param {any} value @returns {value is Kept} */
function isDraft(value) {
  return typeof value?.text === "string" && typeof value?.base === "string";
}

/**
 * Whether a file holds the lesson of a draft: the same heading, every word that opens or ends a test, and half
 * of what stands in its blocks. A page shows its heading, never those words.
 * @param {string} own @param {Kept} draft
 */
function holds(own, { base }) {
  const lines = new Set(linesOf(own));
  const inBlocks = [...base.matchAll(/^(`{3,}|~{3,})[\s\S]*?^\1/gm)].flatMap(([block]) =>
    linesOf(block),
  );
  const there = inBlocks.filter((line) => lines.has(line));
  const words = inBlocks.filter((line) => /\bword["']?\s*:/.test(line));
  return (
    headingOf(base) === headingOf(own) &&
    words.every((line) => lines.has(line)) &&
    2 * there.length >= inBlocks.length
  );
}

/** @param {string} text */
const headingOf = (text) => /^# +(.+?)\s*$/m.exec(text)?.[1];

/** @param {string} text */
const linesOf = (text) =>
  text
    .split(/\r\n?|\n/)
    .map((line) => line.trim())
    .filter(Boolean);
