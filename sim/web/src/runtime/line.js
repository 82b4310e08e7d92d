// The way by which files come. A disk gives all at once or never will. A network drops a request now and
// then, and a slow one that is asked for everything at once finishes nothing for minutes.

/** In ms, before a file that did not come over the network is asked for again. */
const PAUSES = [1000, 2000, 4000];

/** Files under way over the network: two fill a line, and the first of them is there in half of the time. */
const AT_ONCE = 2;

/** Whether the page is from a web server. Asked when it matters: sentences are made when a script begins. */
export const isOnWeb = () => /^https?:$/.test(globalThis.location?.protocol ?? "");

/** Whether its files come over a network: a page of one file has them in itself. */
export const isFetching = () => isOnWeb() && !(/** @type {any} */ (globalThis).__cartsInside);

/**
 * Whether a service worker has all these files in this browser: then it is no network that is slow.
 * @param {URL[]} addresses
 */
export async function areKept(addresses) {
  if (!globalThis.navigator?.serviceWorker?.controller) return false;
  const asked = addresses.map((one) => caches.match(one, { ignoreSearch: true }));
  return (await Promise.all(asked).catch(() => [null])).every(Boolean);
}

/**
 * What `ask` brings; over a network it is asked up to three times again.
 * @template T
 * @param {() => Promise<T>} ask
 * @param {number[]} [pauses]
 * @returns {Promise<T>}
 */
export async function persistently(ask, pauses = isOnWeb() ? PAUSES : []) {
  for (const pause of pauses) {
    try {
      return await ask();
    } catch {
      await new Promise((resolve) => setTimeout(resolve, pause));
    }
  }
  return ask();
}

/** Has tasks done in the order in which they come: from a disk all at once, else few at a time. */
export class Line {
  /** @param {number} [atOnce] */
  constructor(atOnce = isFetching() ? AT_ONCE : Number.POSITIVE_INFINITY) {
    this.free = atOnce;
    /** @type {(() => void)[]} */
    this.waiting = [];
  }

  /** @template T @param {() => Promise<T>} task @returns {Promise<T>} */
  async take(task) {
    if (this.free > 0) this.free -= 1;
    else await new Promise((resolve) => this.waiting.push(() => resolve(undefined)));
    try {
      return await task();
    } finally {
      const next = this.waiting.shift();
      if (next) next();
      else this.free += 1;
    }
  }
}
