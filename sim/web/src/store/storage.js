/**
 * What a reader wrote, kept in this browser: IndexedDB, else localStorage, else only until the
 * page closes, with a warning. `put` resolves when the browser says that the value is kept.
 *
 * Nothing is lost by a new version of a lesson: an answer to an older form of a question (another
 * `hash`) is moved to `earlier` when the new one is answered.
 */

import { stamped } from "../answers/outline.js";
import { STUDENT } from "../shared/code-word.js";
import { instead, takeTexts } from "./brought-over.js";
import { indexed, SETTLED } from "./indexed-store.js";
import { memory, sheltered } from "./shelter.js";
import { letItStay } from "./staying.js";
import { telling } from "./tabs.js";
import { textStore } from "./text-store.js";

/** What the name of a site gets where readings of real carts are kept, apart from its answers. */
export const READINGS = "-measured";

/**
 * `how`: indexed, text (localStorage) or memory. The keys of a student begin with `@CODE/`. `alone`: the
 * caller knows what is kept under the key and has already moved earlier answers: one step less to wait.
 * `behind`: what was kept before lies in a database that does not open now.
 * @typedef {{kind: "kept" | "memory", how: "indexed" | "text" | "memory", behind?: boolean,
 *   get: (key: string) => Promise<any>, put: (key: string, value: unknown, alone?: boolean) => Promise<void>,
 *   remove: (key: string) => Promise<void>, entries: () => Promise<[string, any][]>}} Opened
 * `hear`: what to do when another tab, or another script of this page, has kept something under a key, or forgotten it; until the signal.
 * `student`: the code word whose keys it has; empty: none was given, or it has all.
 * @typedef {Opened & {student: string, hear: (act: (key: string, gone: boolean) => void, signal?: AbortSignal) => void}} Store
 */

/** @type {Map<string, Promise<Store>>} */
const opened = new Map();

/** The whole store of a site. @param {string} site id, so that sites in one folder do not mix @returns {Promise<Store>} */
export function openAll(site) {
  const found = opened.get(site) ?? openOnce(site);
  opened.set(site, found);
  return found;
}

/** The store of the student who works here. @param {string} site @returns {Promise<Store>} */
export async function openStore(site) {
  const all = await openAll(site);
  return forStudent(all, await readStudent(all));
}

/** @param {Store} all @returns {Promise<string>} the code word, empty: none was given */
export async function readStudent(all) {
  const found = await all.get(STUDENT).catch(() => null);
  return typeof found?.code === "string" ? found.code : "";
}

/** @param {Store} all @param {string} code */
export function writeStudent(all, code) {
  return all.put(STUDENT, { code, last: new Date().toISOString() });
}

/** Calls when another tab has said who works here: the last that is kept when all is cleared. @param {Store} all @param {() => void} act */
export function hearStudent(all, act) {
  all.hear((key, gone) => key === STUDENT && !gone && act());
}

/** The same store with one student's keys only. @param {Store} all @param {string} code @returns {Store} */
export function forStudent(all, code) {
  const before = code ? `@${code}/` : "";
  const mine = (/** @type {string} */ key) =>
    before ? key.startsWith(before) : !key.startsWith("@") && key !== STUDENT && key !== SETTLED;
  return {
    kind: all.kind,
    how: all.how,
    student: code,
    get: (key) => all.get(before + key),
    put: (key, value, alone) => {
      letItStay();
      return all.put(before + key, stamped(value), alone);
    },
    remove: (key) => all.remove(before + key),
    hear: (act, signal) =>
      all.hear((key, gone) => mine(key) && act(key.slice(before.length), gone), signal),
    entries: async () =>
      (await all.entries())
        .filter(([key]) => mine(key))
        .map(([key, value]) => [key.slice(before.length), value]),
  };
}

/** @param {string} site @returns {Promise<Store>} */
async function openOnce(site) {
  try {
    const store = telling(sheltered(await indexed(`carts:${site}`), site), site);
    await takeTexts(store, site);
    return store;
  } catch {
    const texts = textStore(site);
    return telling(texts ? await instead(sheltered(texts, site), site) : memory(site), site);
  }
}

/** Where this page's answers are kept: the site's own name for the page, so that a moved folder keeps them. */
/** @returns {{site: string, page: string}} */
export function place() {
  const { cartsSite, cartsPage } = document.documentElement.dataset;
  const meta = (/** @type {string} */ name) =>
    document.querySelector(`meta[name="${name}"]`)?.getAttribute("content");
  const path = location.pathname.split("/").slice(-2).join("/");
  return {
    site: cartsSite ?? meta("carts-site") ?? "site",
    page: cartsPage ?? meta("carts-page") ?? path,
  };
}
