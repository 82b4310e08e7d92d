/** The words of a part of the page; a formula once, not drawn and spoken. */

/** @param {Element | null | undefined} place @returns {string} */
export function plainText(place) {
  if (!place) return "";
  const copy = /** @type {Element} */ (place.cloneNode(true));
  for (const twice of copy.querySelectorAll(".katex-html, annotation")) twice.remove();
  return (copy.textContent ?? "").replace(/\s+/g, " ").trim();
}
