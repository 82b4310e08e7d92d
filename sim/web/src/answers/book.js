/** The answers of one page and one student: read once, written at every input, told to other tabs. */

import { forgetTab } from "../shared/tab.js";
import {
  forStudent,
  hearStudent,
  openAll,
  place,
  READINGS,
  readStudent,
  writeStudent,
} from "../store/storage.js";
import { isEmpty, keepEarlier, merged } from "./entry.js";
import { isOptional, markOptional } from "./optional.js";
import { isCurrent, outline } from "./outline.js";

/** @typedef {import("./entry.js").Entry} Entry */

export class Book extends EventTarget {
  student = "";
  /** @type {import("../store/storage.js").Store | null} */
  store = null;
  /** @type {import("../store/storage.js").Store | null} */
  all = null;
  /** What this page knows, kept or not: a file can have it all. */
  /** @type {Map<string, any>} */
  #known = new Map();
  refused = false;
  /** Whether the browser could not list what was kept before. */
  unread = false;
  /** @type {Set<string>} keys that this page wrote last, no other tab since */
  #own = new Set();
  /** @type {Set<Promise<void>>} */
  #writing = new Set();

  constructor() {
    super();
    const { site, page } = place();
    this.site = site;
    this.page = page;
    /** @type {Promise<void>} */
    this.ready = this.#open();
  }

  /** The key of an answer. @param {string} form @param {string} id */
  key(form, id) {
    return form === "worksheet" ? `${this.page}#${id}` : `${this.page}#${form}:${id}`;
  }

  /** @param {string} form @param {string} id @returns {any} */
  get(form, id) {
    return this.#known.get(this.key(form, id)) ?? null;
  }

  /** Every answer of this student that this page sees. @returns {[string, any][]} */
  entries() {
    return [...this.#known];
  }

  /** Resolves when the browser says that it is kept; rejects when it refuses. @param {string} form @param {any} entry */
  async put(form, entry) {
    const blind = !this.store; // it was written before anybody knew what is kept
    await this.ready;
    const key = this.key(form, entry.id);
    const blindly = blind || (this.unread && !this.#known.has(key));
    const known = this.#known.get(key) ?? (blindly ? await this.#before(key) : undefined);
    const full = (blindly ? merged : keepEarlier)(known, { ...entry, form });
    this.#known.set(key, full);
    const work = this.#write(key, full);
    this.#writing.add(work);
    try {
      await work;
    } finally {
      this.#writing.delete(work);
      this.#changed();
    }
  }

  /** Takes answers from a file in, losing neither side. @param {string} student @param {[string, any][]} found @returns how many are new or changed */
  async take(student, found) {
    await this.ready;
    if (!this.all) return 0;
    const mine = student === this.student;
    const theirs = mine && this.store ? this.store : forStudent(this.all, student);
    const here = new Map(await theirs.entries());
    const changed = found
      .map(([key, entry]) => ({ key, old: here.get(key), both: merged(entry, here.get(key)) }))
      .filter(({ old, both }) => JSON.stringify(both) !== JSON.stringify(old));
    await Promise.all(changed.map(({ key, both }) => theirs.put(key, both)));
    // It may be older than an empty one that this page knows.
    for (const { key, both } of mine ? changed : []) this.#known.set(key, both);
    await this.#read();
    this.#changed();
    for (const [key] of mine ? found : []) {
      this.dispatchEvent(new CustomEvent("elsewhere", { detail: key }));
    }
    return changed.length;
  }

  /**
   * From now on another student works here. Where the browser keeps nothing, a page that is read anew has
   * lost all: there what was answered so far only gets its name.
   * @param {string} code @param {boolean} carry with what was answered so far @returns {Promise<boolean>} whether the page is to be read anew
   */
  async become(code, carry = false) {
    await this.ready;
    if (!this.all) return false;
    if (!this.lasts && (carry || this.#known.size === 0)) {
      this.student = code;
      this.dispatchEvent(new Event("student"));
      this.#changed();
      return false;
    }
    if (carry) {
      const mine = forStudent(this.all, this.student);
      const found = await mine.entries();
      await this.take(code, found);
      for (const [key] of found) await mine.remove(key);
    }
    await writeStudent(this.all, code);
    return true;
  }

  /** Whether the browser keeps anything beyond this page. */
  get lasts() {
    return this.store?.how !== "memory";
  }

  /** Whether a student has answers here. @param {string} code */
  async has(code) {
    await this.ready;
    return this.all ? (await forStudent(this.all, code).entries()).length > 0 : false;
  }

  /** Forgets this student's answers, or everybody's. @param {boolean} everybody */
  async forget(everybody) {
    await this.ready;
    await Promise.allSettled(this.#writing);
    if (!this.all || !this.store) return;
    const readings = await openAll(`${this.site}${READINGS}`); // of real carts: they have no owner
    for (const store of [everybody ? this.all : this.store, readings]) {
      for (const [key] of await store.entries()) await store.remove(key);
    }
    await writeStudent(this.all, "");
    this.#known.clear();
  }

  /** How much of this page is answered. @param {string[]} forms beside the worksheet */
  progress(forms = []) {
    const items = (outline()?.items ?? []).filter(
      ({ id, form, level, type }) =>
        (form === "worksheet" || forms.includes(form)) &&
        level !== "stretch" &&
        type !== "drawn" &&
        !isOptional(id),
    );
    const done = items.filter((item) => {
      const entry = this.get(item.form, item.id);
      const predicted = ["arrows", "curve", "choice", "text"].includes(item.type);
      const unread = item.type === "number" && typeof entry?.value === "string"; // as it was typed
      return (
        entry && isCurrent(entry) && (predicted ? entry.locked : !isEmpty(entry.value) && !unread)
      );
    });
    return { done: done.length, of: items.length };
  }

  #changed() {
    this.dispatchEvent(new Event("change"));
  }

  async #open() {
    markOptional(); // once: what is done is counted with every answer
    this.all = await openAll(this.site);
    this.student = await readStudent(this.all);
    this.store = forStudent(this.all, this.student);
    await this.#read();
    this.store.hear((key, gone) => void this.#hear(key, gone));
    hearStudent(this.all, () => this.#leave());
    for (const kind of ["carts-kept", "carts-forgotten"]) {
      document.addEventListener(kind, (event) => {
        void this.#hear(/** @type {CustomEvent} */ (event).detail, kind === "carts-forgotten");
      });
    }
  }

  /** What is kept under a key that this page does not know. @param {string} key */
  async #before(key) {
    try {
      return await this.store?.get(key);
    } catch (error) {
      this.refused = true;
      throw error;
    }
  }

  async #read() {
    const found = await this.store?.entries().catch(() => null);
    this.unread = !found || this.all?.behind === true;
    for (const [key, entry] of found ?? []) {
      const known = this.#known.get(key);
      if (!known || String(known.last ?? "") <= String(entry?.last ?? "")) {
        this.#known.set(key, entry);
      }
    }
  }

  /** Takes in what another script has kept. */
  async refresh() {
    await this.#read();
    this.#changed();
  }

  /** @param {string} key @param {any} entry */
  async #write(key, entry) {
    try {
      await this.store?.put(key, entry, this.#own.has(key));
      this.#own.add(key);
    } catch (error) {
      this.refused = true;
      throw error;
    }
  }

  /** In another tab somebody else works now, or all was cleared: what this tab holds is not to be shown or kept again. */
  #leave() {
    forgetTab();
    location.reload();
  }

  /** Another tab, or another script, has kept something or forgotten it. @param {string} key @param {boolean} gone */
  async #hear(key, gone) {
    this.#own.delete(key);
    const entry = await this.store?.get(key).catch(() => null);
    if (entry) this.#known.set(key, entry);
    else if (gone) this.#known.delete(key);
    else return;
    this.#changed();
    this.dispatchEvent(new CustomEvent("elsewhere", { detail: key }));
  }
}
