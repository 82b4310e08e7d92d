/**
 * The way into teacher mode: the link at the foot of a lesson, or an address that ends in #teacher or
 * ?teacher. Its script is loaded then, never before.
 */

export const OPEN = "carts-teach";

/** Listens for a teacher. */
export function teacherDoor() {
  const link = document.querySelector(".carts-teach-door a");
  if (!(link instanceof HTMLAnchorElement)) return;
  const lesson = new URL(link.dataset.lesson ?? "", document.baseURI);
  const beside = (/** @type {string} */ name) => new URL(`../${name}${lesson.search}`, lesson).href;
  /** @type {Promise<unknown> | null} */
  let loaded = null;
  const open = async () => {
    loaded ??= Promise.all([style(beside("teacher.css")), script(beside("teacher.js"))]);
    try {
      await loaded;
      document.dispatchEvent(new Event(OPEN));
    } catch {
      loaded = null;
      link.textContent = "Teacher mode cannot be loaded: a file of this site is missing.";
    }
  };
  const wanted = () =>
    location.hash === "#teacher" || new URLSearchParams(location.search).has("teacher");
  link.addEventListener("click", () => void open());
  addEventListener("hashchange", () => {
    if (location.hash === "#teacher") void open();
  });
  if (wanted()) void open();
}

/** @param {string} address */
function script(address) {
  const made = document.createElement("script");
  made.src = address;
  return arrives(made);
}

/** @param {string} address */
function style(address) {
  const made = document.createElement("link");
  made.rel = "stylesheet";
  made.href = address;
  return arrives(made);
}

/** @param {HTMLElement} element */
function arrives(element) {
  return new Promise((resolve, reject) => {
    element.onload = resolve;
    element.onerror = reject;
    document.head.append(element);
  });
}
