/**
 * What a reader wrote, kept in this browser: IndexedDB, else localStorage, else only until the
 * page closes, with a warning. `put` resolves when the browser says that the value is kept.
 *
 * Nothing is lost by a new version of a lesson: an answer to an older form of a question (another
 * `hash`) is moved to `earlier` when the new one is answered.
 */

import { keepEarlier } from "../answers/entry.js";
import { stamped } from "../answers/outline.js";

/** What the name of a site gets where readings of real carts are kept, apart from its answers. */
export const READINGS = "-measured";
const STORE = "answers";
// ms until a browser that never answers counts as one that keeps nothing; after a crash it is slow.
const PATIENCE = 20_000;
const STUDENT = "student"; // the key under which the code word of who works here is kept
const SETTLED = "settled"; // written last, so that all before it is on the disk
const SETTLE_AFTER = 400; // ms without a new answer

/**
 * `how`: indexed, text (localStorage) or memory. The keys of a student begin with `@CODE/`. `alone`: the
 * caller knows what is kept under the key and has already moved earlier answers: one step less to wait.
 * @typedef {{kind: "kept" | "memory", how: "indexed" | "text" | "memory",
 *   get: (key: string) => Promise<any>, put: (key: string, value: unknown, alone?: boolean) => Promise<void>,
 *   remove: (key: string) => Promise<void>, entries: () => Promise<[string, any][]>}} Store
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

/** The same store with one student's keys only. @param {Store} all @param {string} code @returns {Store} */
export function forStudent(all, code) {
  const before = code ? `@${code}/` : "";
  const mine = (/** @type {string} */ key) =>
    before ? key.startsWith(before) : !key.startsWith("@") && key !== STUDENT && key !== SETTLED;
  return {
    kind: all.kind,
    how: all.how,
    get: (key) => all.get(before + key),
    put: (key, value, alone) => all.put(before + key, stamped(value), alone),
    remove: (key) => all.remove(before + key),
    entries: async () =>
      (await all.entries())
        .filter(([key]) => mine(key))
        .map(([key, value]) => [key.slice(before.length), value]),
  };
}

/** @param {string} site @returns {Promise<Store>} */
async function openOnce(site) {
  try {
    return sheltered(indexed(await reopening(`carts:${site}`)));
  } catch {
    const texts = textStore(site);
    return texts ? sheltered(texts) : memory();
  }
}

/** @param {string} name @returns {Promise<IDBDatabase>} */
function open(name) {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(name, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE);
    request.onsuccess = () => {
      request.result.onversionchange = () => request.result.close();
      resolve(request.result);
    };
    request.onerror = () => reject(request.error);
    request.onblocked = () => reject(new Error("another page holds an older version"));
    setTimeout(() => reject(new Error("no answer")), PATIENCE);
  });
}

/** @typedef {(mode: IDBTransactionMode, durability?: IDBTransactionDurability) => Promise<IDBTransaction>} Begin */

/** Begins transactions; where the browser has closed the database (site data cleared), in a new one. */
/** @param {string} name @returns {Promise<Begin>} */
async function reopening(name) {
  let base = await open(name);
  return async (mode, durability = "relaxed") => {
    try {
      return base.transaction(STORE, mode, { durability });
    } catch {
      base = await open(name);
      return base.transaction(STORE, mode, { durability });
    }
  };
}

/** @param {Begin} begin @returns {Store} */
function indexed(begin) {
  /** @template T @param {(answers: IDBObjectStore) => IDBRequest<T>} ask @returns {Promise<T>} */
  const read = async (ask) => {
    const work = await begin("readonly");
    return new Promise((resolve, reject) => {
      const request = ask(work.objectStore(STORE));
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
  };
  return {
    kind: "kept",
    how: "indexed",
    get: (key) => read((answers) => answers.get(key)),
    put: (key, value, alone = false) =>
      write(begin, (answers) => {
        if (alone) {
          answers.put(value, key);
          answers.transaction.commit(); // nothing else will come
          return;
        }
        const request = answers.get(key);
        request.onsuccess = () => answers.put(keepEarlier(request.result, value), key);
      }),
    remove: (key) => write(begin, (answers) => answers.delete(key)),
    entries: async () => {
      const [keys, values] = await Promise.all([
        read((answers) => answers.getAllKeys()),
        read((answers) => answers.getAll()),
      ]);
      return keys.map((key, k) => [String(key), values[k]]);
    },
  };
}

/** @type {ReturnType<typeof setTimeout> | undefined} */
let settling;

/**
 * What is complete survives a browser that is killed: the system has it. Waiting for the disk at every
 * key would let fast typing queue up; so that is done once, in a pause, for a computer that loses power.
 * @param {Begin} begin @param {(answers: IDBObjectStore) => void} act
 */
async function write(begin, act) {
  await transaction(begin, act, "relaxed");
  clearTimeout(settling);
  settling = setTimeout(() => {
    const mark = (/** @type {IDBObjectStore} */ answers) => void answers.put(Date.now(), SETTLED);
    transaction(begin, mark, "strict").catch(() => {}); // the answer itself was kept or refused before
  }, SETTLE_AFTER);
}

/** @param {Begin} begin @param {(answers: IDBObjectStore) => void} act @param {IDBTransactionDurability} durability @returns {Promise<void>} */
async function transaction(begin, act, durability) {
  const work = await begin("readwrite", durability);
  return new Promise((resolve, reject) => {
    act(work.objectStore(STORE));
    work.oncomplete = () => resolve();
    work.onerror = () => reject(work.error);
    work.onabort = () => reject(work.error);
  });
}

/** @param {string} site @returns {Store | null} */
function textStore(site) {
  const before = `carts:${site}:`;
  try {
    localStorage.setItem(`${before}probe`, "1");
    localStorage.removeItem(`${before}probe`);
  } catch {
    return null;
  }
  const get = (/** @type {string} */ key) =>
    JSON.parse(localStorage.getItem(before + key) ?? "null");
  return {
    kind: "kept",
    how: "text",
    get: async (key) => get(key),
    put: async (key, value) =>
      localStorage.setItem(before + key, JSON.stringify(keepEarlier(get(key), value))),
    remove: async (key) => localStorage.removeItem(before + key),
    entries: async () =>
      Object.keys(localStorage)
        .filter((name) => name.startsWith(before))
        .map((name) => [name.slice(before.length), get(name.slice(before.length))]),
  };
}

/**
 * What a browser refuses to keep, as long as the page is open: it can still be saved as a file. The
 * scripts of a page share it.
 * @returns {Map<string, any>}
 */
function shelter() {
  const page = /** @type {any} */ (globalThis);
  const name = Symbol.for("carts-shelter");
  page[name] ??= new Map();
  return page[name];
}

/** The same store, and what it refused. @param {Store} store @returns {Store} */
function sheltered(store) {
  return {
    ...store,
    put: async (key, value, alone) => {
      try {
        await store.put(key, value, alone);
        shelter().delete(key);
      } catch (error) {
        shelter().set(key, keepEarlier(shelter().get(key), value));
        throw error;
      }
    },
    remove: async (key) => {
      shelter().delete(key);
      await store.remove(key);
    },
    entries: async () => [...new Map([...(await store.entries()), ...shelter()])],
  };
}

/** @returns {Store} */
function memory() {
  const kept = shelter();
  return {
    kind: "memory",
    how: "memory",
    get: async (key) => kept.get(key),
    put: async (key, value) => void kept.set(key, keepEarlier(kept.get(key), value)),
    remove: async (key) => void kept.delete(key),
    entries: async () => [...kept],
  };
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
