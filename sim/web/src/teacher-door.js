/**
 * The way into teacher mode: the link at the foot of a lesson, or an address that ends in #teacher or
 * ?teacher. Its script is loaded then, never before.
 */

export const OPEN = "carts-teach";

/** Listens for a teacher. */
export function teacherDoor() {
  const link = document.querySelector(".carts-teach-door a");
  if (!(link instanceof HTMLAnchorElement)) return;
  const assets = new URL("../", new URL(link.dataset.lesson ?? "", document.baseURI));
  /** @type {Promise<unknown> | null} */
  let loaded = null;
  const open = async () => {
    loaded ??= Promise.all([style(new URL("teacher.css", assets)), script(assets)]);
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

/** @param {URL} assets */
function script(assets) {
  const made = document.createElement("script");
  made.src = new URL("teacher.js", assets).href;
  return arrives(made);
}

/** @param {URL} address */
function style(address) {
  const made = document.createElement("link");
  made.rel = "stylesheet";
  made.href = address.href;
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
