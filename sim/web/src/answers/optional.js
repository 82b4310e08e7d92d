/** Parts that a lesson marks as for who has time: what stands below such a heading, up to the next of its kind. */

const OPTIONAL = "carts-optional";

/** Marks them, for paper and for the count of what is done. */
export function markOptional() {
  let optional = false;
  for (const one of document.querySelector(".md-content__inner")?.children ?? []) {
    if (/^H[12]$/.test(one.tagName)) optional = one.classList.contains("more");
    one.classList.toggle(OPTIONAL, optional);
  }
}

/** @param {string} id of a question or a scene of the page */
export function isOptional(id) {
  return Boolean(document.getElementById(id)?.closest(`.${OPTIONAL}`));
}
