/**
 * A question, and text below a scene (`!!! after`), that opens when the scene was watched: it often
 * tells what was seen; one on forces that the scene hides, when they were found. It opens too where nothing
 * is left to watch (Python cannot start, no run was prepared), for who answered it before, and by the
 * teacher's key in “My answers”. When the scene is begun again, it waits again.
 */

const OPEN_ALL = "carts-open-questions";

/** @param {HTMLElement & {answered?: boolean}} element answered: now, or before @param {AbortSignal} signal */
export function wait(element, signal) {
  const id = element.dataset.after;
  if (!id) return;
  const open = () => (element.dataset.opened ??= "");
  const seen = element.dataset.found === undefined ? "watched" : "found";
  const look = () => {
    const scene = document.getElementById(id);
    if (!scene || [seen, "unshown"].some((name) => name in scene.dataset)) open();
  };
  if (element.answered) open();
  // A page that is made anew may put this in its place before its scene.
  queueMicrotask(() => signal.aborted || look());
  for (const kind of ["carts-watched", "carts-found", "carts-error"]) {
    document.addEventListener(kind, look, { signal });
  }
  const byKey = () => (element.dataset.opened = "key");
  document.addEventListener(OPEN_ALL, byKey, { signal });
  const close = (/** @type {Event} */ { target }) => {
    const again = /** @type {Element} */ (target).id === id && element.dataset.opened === "";
    if (again && !element.answered) delete element.dataset.opened;
  };
  document.addEventListener("carts-unwatched", close, { signal });
}

/** `<carts-after>`: text that waits. */
export class CartsAfter extends HTMLElement {
  #leaving = new AbortController();

  connectedCallback() {
    this.#leaving = new AbortController();
    wait(this, this.#leaving.signal);
  }

  disconnectedCallback() {
    this.#leaving.abort();
  }
}

/** Whether anything of this page still waits. */
export function anyWaits() {
  return document.querySelector("[data-after]:not([data-opened])") !== null;
}

/** The teacher's key: all of this page. */
export function openAll() {
  document.dispatchEvent(new Event(OPEN_ALL));
}
