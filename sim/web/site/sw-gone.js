// This site is no longer kept on readers' computers: what an earlier version kept is forgotten.

(() => {
  /** @type {any} */
  const worker = self;
  const OURS = `carts ${"@@SITE@@"} ${new URL("./", worker.location.href).pathname} `;

  worker.addEventListener("install", () => worker.skipWaiting());
  worker.addEventListener("activate", (/** @type {any} */ event) => {
    event.waitUntil(forget());
  });

  async function forget() {
    for (const name of await caches.keys()) if (name.startsWith(OURS)) await caches.delete(name);
    await worker.registration.unregister();
  }
})();
