// Hosted pages only: has the service worker keep the site on this computer, and tells it what this
// page has loaded beside the parts that are kept at once.

(() => {
  const own = /** @type {HTMLScriptElement} */ (document.currentScript).src;
  const root = new URL("../../", own);
  const workers = navigator.serviceWorker;
  const connection = /** @type {any} */ (navigator).connection;
  if (!workers || !isSecureContext || connection?.saveData) return;

  const state = (/** @type {string} */ text) => {
    document.documentElement.dataset.offline = text;
  };

  /**
   * A newer version of the site that waits takes over when a page is opened and no other is open: so
   * no page is ever answered from two versions.
   */
  async function renew() {
    const waiting = (await workers.getRegistration(root))?.waiting;
    if (!waiting || !workers.controller) return;
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = ({ data }) => {
      if (data !== 1) return;
      workers.addEventListener("controllerchange", () => location.reload(), { once: true });
      waiting.postMessage("go");
    };
    workers.controller.postMessage("pages", [port2]);
  }

  async function keep() {
    const options = /** @type {RegistrationOptions} */ ({ updateViaCache: "none" });
    await workers.register(new URL("sw.js", root), options);
    const { active } = await workers.ready;
    state("ready");
    if (workers.controller || !active) return; // a controlled page asks it for every file
    const seen = new PerformanceObserver((list) => {
      active.postMessage({ keep: list.getEntries().map((entry) => entry.name) });
    });
    seen.observe({ type: "resource", buffered: true });
  }

  renew().catch(() => {});
  const begin = () => keep().catch(() => state("refused")); // the site works without it
  if (document.readyState === "complete") begin();
  else addEventListener("load", begin);
})();
