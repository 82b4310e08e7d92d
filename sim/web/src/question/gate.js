/**
 * A question, and text below a scene (`!!! after`), that opens when the scene was watched: it often
 * tells what was seen; one on forces that the scene hides, when they were found. It opens too where no run can be had (Python cannot start), for who answered it before, and by the
 * teacher's key in “My answers”.
 */

const OPEN_ALL = "carts-open-questions";

/** @param {HTMLElement} element @param {boolean} answered before @param {AbortSignal} signal */
export function wait(element, answered, signal) {
  const id = element.dataset.after;
  if (!id || element.dataset.opened !== undefined) return;
  const open = () => (element.dataset.opened = "");
  const seen = element.dataset.found === undefined ? "watched" : "found";
  const look = () => {
    const scene = document.getElementById(id);
    if (!scene || [seen, "reason"].some((name) => name in scene.dataset)) open();
  };
  if (answered) return open();
  // A page that is made anew may put this in its place before its scene.
  queueMicrotask(() => signal.aborted || look());
  for (const kind of ["carts-watched", "carts-found", "carts-error"]) {
    document.addEventListener(kind, look, { signal });
  }
  document.addEventListener(OPEN_ALL, open, { signal });
}

/** `<carts-after>`: text that waits. */
export class CartsAfter extends HTMLElement {
  #leaving = new AbortController();

  connectedCallback() {
    this.#leaving = new AbortController();
    wait(this, false, this.#leaving.signal);
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
