/**
 * What a reader wrote, kept in this browser: IndexedDB, else localStorage, else only until the
 * page closes, with a warning. `put` resolves when the browser says that the value is kept.
 */

const STORE = "answers";

/** @typedef {{kind: "kept" | "memory", get: (key: string) => Promise<any>, put: (key: string, value: unknown) => Promise<void>,
 *   remove: (key: string) => Promise<void>}} Store */

/** @param {string} site id of the site, so that sites in one folder do not mix @returns {Promise<Store>} */
export async function openStore(site) {
  try {
    return indexed(await open(`carts:${site}`));
  } catch {
    return textStore(site) ?? memory();
  }
}

/** @param {string} name @returns {Promise<IDBDatabase>} */
function open(name) {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(name, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE);
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
    request.onblocked = () => reject(new Error("another page holds an older version"));
  });
}

/** @param {IDBDatabase} base @returns {Store} */
function indexed(base) {
  return {
    kind: "kept",
    get: (key) =>
      new Promise((resolve, reject) => {
        const request = base.transaction(STORE).objectStore(STORE).get(key);
        request.onsuccess = () => resolve(request.result);
        request.onerror = () => reject(request.error);
      }),
    put: (key, value) => write(base, (answers) => answers.put(value, key)),
    remove: (key) => write(base, (answers) => answers.delete(key)),
  };
}

/** @param {IDBDatabase} base @param {(answers: IDBObjectStore) => void} act @returns {Promise<void>} */
function write(base, act) {
  return new Promise((resolve, reject) => {
    const work = base.transaction(STORE, "readwrite", { durability: "strict" });
    act(work.objectStore(STORE));
    work.oncomplete = () => resolve();
    work.onerror = () => reject(work.error);
    work.onabort = () => reject(work.error);
  });
}

/** @param {string} site @returns {Store | null} */
function textStore(site) {
  try {
    const probe = `carts:${site}:probe`;
    localStorage.setItem(probe, "1");
    localStorage.removeItem(probe);
  } catch {
    return null;
  }
  return {
    kind: "kept",
    get: async (key) => JSON.parse(localStorage.getItem(`carts:${site}:${key}`) ?? "null"),
    put: async (key, value) => localStorage.setItem(`carts:${site}:${key}`, JSON.stringify(value)),
    remove: async (key) => localStorage.removeItem(`carts:${site}:${key}`),
  };
}

/** @returns {Store} */
function memory() {
  const kept = new Map();
  return {
    kind: "memory",
    get: async (key) => kept.get(key),
    put: async (key, value) => void kept.set(key, value),
    remove: async (key) => void kept.delete(key),
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
