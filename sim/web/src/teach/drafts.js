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

  /**
   * Of a lesson whose text is not in the site: a draft belongs to the file that it began from, and is brought
   * back to no other. Drafts hold what the page must not show, such as the words that open a test: whoever
   * opens another file is told nothing of them.
   * @param {string} own the file's text @param {string} hash of it
   * @returns {Promise<{draft: Draft | null, earlier: Draft[]}>}
   */
  async ofFile(own, hash) {
    const published = hash !== "" && hash === this.hash;
    const found = [await this.current(), ...(await this.earlier())].filter((one) => one !== null);
    const draft =
      found.find(({ base }) => base === own) ??
      found.find((one) => published && one.hash === hash) ??
      null;
    this.hash = draft?.hash ?? (hash || sumOf(own)); // what is kept now leaves the others as they are
    return { draft, earlier: found.filter((one) => one !== draft && holds(own, one)) };
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

/** A name for a text where the browser has no sha256. @param {string} text */
function sumOf(text) {
  let sum = 7;
  for (const sign of text) sum = (Math.imul(sum, 31) + Number(sign.codePointAt(0))) >>> 0;
  return `${text.length}-${sum.toString(16)}`;
}

/** @param {any} value @returns {value is Draft} */
function isDraft(value) {
  return typeof value?.text === "string" && typeof value?.base === "string";
}

/**
 * Whether a file holds the lesson of a draft: the same heading, every word that opens or ends a test, and half
 * of what stands in its blocks. A page shows its heading, never those words.
 * @param {string} own @param {Draft} draft
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
