/** Whether Python computes for a scene, as its reader sees it: still, starting, live or failed. */

import { need } from "../shared/dom.js";
import { deferred, frame } from "../shared/waiting.js";
import * as words from "./element-words.js";
import { WATCHED } from "./time/watch.js";

/**
 * @typedef {{first: () => Promise<void>, told: () => boolean, stepwise: () => boolean, link: () => void,
 *   failed: () => void}} Acts `first` asks for the first run and shows it; `told`: no prediction is
 *   waited for; `link` follows the page's address; `stepwise`: there are runs that need no Python
 */

export class Live {
  #waiting = deferred();
  #linked = ""; // the address of a state that was followed

  /** @param {HTMLElement} element @param {import("../runtime/client.js").Client} client @param {Acts} acts */
  constructor(element, client, acts) {
    this.element = element;
    this.client = client;
    this.acts = acts;
    this.#waiting.promise.catch(() => {}); // readers see the state; nobody has to listen
  }

  /** Resolves when Python has answered for this scene; rejects when it cannot start. */
  get ready() {
    return this.#waiting.promise;
  }

  /** @param {AbortSignal} signal */
  listen(signal) {
    this.client.addEventListener("state", () => this.follow(), { signal });
    for (const what of /** @type {const} */ (["slow", "slow-line"])) {
      this.client.addEventListener(what, () => this.#slow(what), { once: true, signal });
    }
    // A link that is opened where the page is open already; and one that waited for a prediction.
    addEventListener("hashchange", () => this.#link(), { signal });
    this.element.addEventListener(WATCHED, () => this.#link(), { signal });
  }

  /** Follows the page's address, once, if it asks for a state of this scene. */
  #link() {
    const { state } = this.element.dataset;
    const able = state === "live" || (state === "failed" && this.acts.stepwise());
    if (!able || !this.acts.told()) return;
    if (this.#linked === location.hash) return;
    this.#linked = location.hash;
    this.acts.link();
  }

  /** The picture stands: Python starts at the first touch at the latest. */
  still() {
    for (const kind of ["pointerdown", "keydown", "focusin"]) {
      this.element.addEventListener(kind, () => this.client.wake(), { once: true, passive: true });
    }
    requestAnimationFrame(() => requestAnimationFrame(() => performance.mark("carts:still")));
  }

  /** A weak computer needs long for a step of the start, a weak network for its files: that is said, and no
   * reason to give up. @param {"slow" | "slow-line"} what */
  #slow(what) {
    if (this.element.dataset.state !== "starting") return;
    const told = words.slow(what, this.acts.told() && this.acts.stepwise());
    words.passing(this.element, told, true);
    this.#waiting.promise.then(() => words.passing(this.element, told, false)).catch(() => {});
  }

  /** Follows the page's worker. */
  follow() {
    const { state } = this.client;
    const { dataset } = this.element;
    if (state === "starting" || state === "idle") {
      dataset.state = state === "idle" ? "still" : "starting";
    } else if (state === "failed") this.#fail();
    else if (dataset.state !== "live") void this.#begin();
    else this.#mark();
  }

  /** @param {boolean} again whether a refused value may be behind it: it was given up meanwhile @returns {Promise<void>} */
  async #begin(again = true) {
    try {
      await this.acts.first();
      await frame();
      if (this.client.state !== "ready") return;
      this.element.dataset.state = "live";
      this.#mark();
      performance.mark("carts:live");
      this.#waiting.resolve(undefined);
      this.#link();
    } catch (error) {
      if (this.client.state === "failed") return;
      if (again && /** @type {any} */ (error).refused) return this.#begin(false);
      this.#fail(/** @type {Error} */ (error));
    }
  }

  #mark() {
    need(this.element, ".carts-mark").setAttribute("aria-label", words.LIVE);
  }

  /** Whether nothing is left to watch or to find: no run was prepared, and that of the page is not all. */
  get #nothing() {
    const more = this.element.querySelector(".carts-find, .carts-preset");
    return !this.acts.stepwise() && (!this.acts.told() || more !== null);
  }

  /** @param {Error & {reason?: string}} error */
  #fail(error = this.client.error ?? new Error(words.NOT_STARTED)) {
    const { dataset } = this.element;
    dataset.state = "failed";
    dataset.reason = error.reason ?? "failed";
    if (this.#nothing) dataset.unshown = "";
    this.acts.failed();
    const note = need(this.element, ".carts-note");
    note.dataset.why = `${error.message} ${words.without(this.acts.told(), this.acts.stepwise())}`;
    words.note(this.element, note.dataset.why);
    this.#waiting.reject(error);
    this.#link();
    this.element.dispatchEvent(new CustomEvent("carts-error", { bubbles: true, detail: error }));
  }
}
