// Keeps a hosted site on this computer, so that it opens without a network after the first visit.
//
// A version of the site is kept whole or not at all: every file is checked against its hash before the
// new version counts, and a page is answered from one version only. Answers are not here: they are
// in the page's own store, which this script never touches.

(() => {
  /** @type {any} */
  const worker = self;
  const VERSION = "@@VERSION@@";
  /** @type {Record<string, [string, 0 | 1]>} hash of each file; 1: kept at once, 0: when a page loads it */
  const FILES = /** @type {any} */ ("@@FILES@@");
  const ROOT = new URL("./", worker.location.href);
  const OURS = `carts ${"@@SITE@@"} ${ROOT.pathname} `; // another site of the same host has another path
  const CACHE = OURS + VERSION;
  const AT_ONCE = 6; // files under way

  worker.addEventListener("install", (/** @type {any} */ event) => {
    event.waitUntil(keepAll());
  });

  worker.addEventListener("activate", (/** @type {any} */ event) => {
    event.waitUntil(forgetOthers());
  });

  worker.addEventListener("message", (/** @type {any} */ event) => {
    if (event.data === "go") worker.skipWaiting();
    else if (event.data === "pages") pages().then((count) => event.ports[0].postMessage(count));
    else if (Array.isArray(event.data?.keep)) event.waitUntil(keepLater(event.data.keep));
  });

  worker.addEventListener("fetch", (/** @type {any} */ event) => {
    const { request } = event;
    const name = nameOf(request.url);
    if (request.method !== "GET" || name === null) return;
    if (request.mode === "navigate") event.respondWith(page(name, request));
    else if (name in FILES) event.respondWith(file(name));
  });

  /** @param {string} url @returns {string | null} the file's path in the site; null: it is none of ours */
  function nameOf(url) {
    const { origin, pathname } = new URL(url);
    if (origin !== ROOT.origin || !pathname.startsWith(ROOT.pathname)) return null;
    const path = decodeURIComponent(pathname.slice(ROOT.pathname.length));
    return path === "" || path.endsWith("/") ? `${path}index.html` : path;
  }

  /** @param {string} name */
  const addressOf = (name) => new URL(name.split("/").map(encodeURIComponent).join("/"), ROOT).href;

  /** @param {string} name @param {Request} request */
  async function page(name, request) {
    if (name in FILES) return file(name);
    return fetch(request).catch(() => file("404.html"));
  }

  /** How many pages of this site are open. */
  async function pages() {
    return (await worker.clients.matchAll({ type: "window" })).length;
  }

  /** @param {string} name */
  async function file(name) {
    const cache = await caches.open(CACHE);
    const kept = await cache.match(addressOf(name));
    if (kept) return kept;
    try {
      const found = await fetched(name);
      await cache.put(addressOf(name), found.clone()).catch(() => {}); // a full disk: it is read all the same
      return found;
    } catch {
      worker.registration.update().catch(() => {}); // perhaps the site was published anew
      return Response.error();
    }
  }

  /** A file from the network, if it is the one of this version. @param {string} name @returns {Promise<Response>} */
  async function fetched(name) {
    const found = await fetch(addressOf(name), { cache: "no-cache" });
    const bytes = await found.arrayBuffer();
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    const hash = [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    if (!found.ok || !hash.startsWith(/** @type {any} */ (FILES[name])[0])) {
      throw new Error(`${name} is not of this version`);
    }
    const type = found.headers.get("Content-Type") ?? "application/octet-stream";
    return new Response(bytes, { headers: { "Content-Type": type, "X-Carts-Hash": hash } });
  }

  async function keepAll() {
    const cache = await caches.open(CACHE);
    const older = await olderCaches();
    const names = Object.keys(FILES).filter((name) => FILES[name]?.[1]);
    const next = async () => {
      for (let name = names.pop(); name !== undefined; name = names.pop()) {
        if (await cache.match(addressOf(name))) continue;
        const found = (await fromOlder(older, name)) ?? (await fetched(name));
        await cache.put(addressOf(name), found);
      }
    };
    try {
      await Promise.all(Array.from({ length: AT_ONCE }, next));
    } catch (error) {
      names.length = 0;
      throw error; // the older version stays; the browser tries again at a later visit
    }
  }

  /** What an older version has with the same hash need not be loaded again. @param {Cache[]} older @param {string} name */
  async function fromOlder(older, name) {
    for (const cache of older) {
      const found = await cache.match(addressOf(name));
      const hash = FILES[name]?.[0] ?? "";
      if (found?.headers.get("X-Carts-Hash")?.startsWith(hash)) return found;
    }
    return null;
  }

  async function olderCaches() {
    const names = (await caches.keys()).filter((name) => name.startsWith(OURS) && name !== CACHE);
    return Promise.all(names.map((name) => caches.open(name)));
  }

  async function forgetOthers() {
    const cache = await caches.open(CACHE);
    const older = await olderCaches();
    for (const [name, [, atOnce]] of Object.entries(FILES)) {
      if (atOnce) continue; // what a reader has used before stays there, if it is still the same
      const found = await fromOlder(older, name);
      if (found) await cache.put(addressOf(name), found);
    }
    for (const name of await caches.keys()) {
      if (name.startsWith(OURS) && name !== CACHE) await caches.delete(name);
    }
  }

  /** What a page has loaded before this worker was there. @param {string[]} addresses */
  async function keepLater(addresses) {
    const names = addresses.map(nameOf).filter((name) => name !== null && name in FILES);
    for (const name of names) await file(/** @type {string} */ (name));
  }
})();
