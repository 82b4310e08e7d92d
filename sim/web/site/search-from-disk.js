// Search that works by double click.
//
// The theme starts its search in a worker from a file, and from a web server it fetches the index.
// A page opened from disk may do neither. So the worker's text travels in this script (the
// generator puts it in below) and is started as a Blob; every other worker is the browser's own.
// The name of the built file contains "iframe-worker": the theme then adds no polyfill of its own.

(() => {
  /** @type {string} */
  const workerText = "@@SEARCH_WORKER@@";
  const isSearchWorker = /\/assets\/javascripts\/workers\/search\.[^/]*\.js$/;
  const isIndex = /\/search\/search_index\.json$/;

  const Native = window.Worker;
  window.Worker = new Proxy(Native, {
    construct(target, [url, ...rest]) {
      if (!isSearchWorker.test(String(new URL(url, location.href))))
        return new target(url, ...rest);
      const blob = new Blob([workerText], { type: "text/javascript" });
      return new target(URL.createObjectURL(blob));
    },
  });

  // The same folder on a web server: the policy allows no connection, so the index comes as the
  // script that is there for the disk.
  if (location.protocol === "file:") return;
  const { open, send } = XMLHttpRequest.prototype;
  /** @type {WeakMap<XMLHttpRequest, string>} */
  const indexes = new WeakMap();

  /** @this {XMLHttpRequest} @param {any[]} given */
  XMLHttpRequest.prototype.open = function (...given) {
    const address = String(new URL(given[1], location.href));
    if (isIndex.test(address)) indexes.set(this, address.replace(/json$/, "js"));
    return Reflect.apply(open, this, given);
  };

  /** @this {XMLHttpRequest} @param {any} body */
  XMLHttpRequest.prototype.send = function (body) {
    const address = indexes.get(this);
    if (!address) return send.call(this, body);
    const script = document.createElement("script");
    script.src = address;
    script.onload = () => {
      const index = new Blob([JSON.stringify(/** @type {any} */ (window).__index)]);
      Object.defineProperties(this, { status: { value: 200 }, response: { value: index } });
      this.dispatchEvent(new Event("load"));
    };
    script.onerror = () => this.dispatchEvent(new Event("error"));
    document.head.append(script);
  };
})();
