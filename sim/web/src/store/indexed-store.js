/**
 * The store in IndexedDB: one value under each key. What is complete survives a browser that is killed.
 */

import { keepEarlier } from "../answers/entry.js";
import { GONE, newestFirst } from "./newest-first.js";

/** @typedef {import("./storage.js").Opened} Opened */

/** The key that is written last, so that all before it is on the disk. */
export const SETTLED = "settled";
const STORE = "answers";
// ms until a browser that never answers counts as one that keeps nothing; after a crash it is slow.
const PATIENCE = 20_000;
const SETTLE_AFTER = 400; // ms without a new answer

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

/** The store in this database. @param {string} name @returns {Promise<Opened>} */
export async function indexed(name) {
  const begin = await reopening(name);
  /** @template T @param {(answers: IDBObjectStore) => IDBRequest<T>} ask @returns {Promise<T>} */
  const read = async (ask) => answered(ask((await begin("readonly")).objectStore(STORE)));
  const put = newestFirst((key, value, alone) =>
    write(begin, (answers) => {
      if (value === GONE) answers.delete(key);
      else if (alone) {
        answers.put(value, key);
        answers.transaction.commit(); // nothing else will come
      } else {
        const request = answers.get(key);
        request.onsuccess = () => answers.put(keepEarlier(request.result, value), key);
      }
    }),
  );
  return {
    kind: "kept",
    how: "indexed",
    get: (key) => read((answers) => answers.get(key)),
    put,
    remove: (key) => put(key, GONE),
    entries: async () => {
      // In one transaction: what another tab writes between two would move the values by a key.
      const answers = (await begin("readonly")).objectStore(STORE);
      const [keys, values] = await Promise.all([
        answered(answers.getAllKeys()),
        answered(answers.getAll()),
      ]);
      return keys.map((key, k) => [String(key), values[k]]);
    },
  };
}

/** @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
function answered(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
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
