/** The words of a part of the page; a formula once, not drawn and spoken; of a picture its own. */

/** @param {Element | null | undefined} place @returns {string} */
export function plainText(place) {
  if (!place) return "";
  const copy = /** @type {Element} */ (place.cloneNode(true));
  for (const part of copy.querySelectorAll(".katex-html, annotation")) part.remove();
  for (const part of copy.querySelectorAll("img")) part.replaceWith(part.alt);
  for (const fraction of [...copy.querySelectorAll("mfrac")].reverse()) {
    fraction.textContent = [...fraction.children].map(grouped).join("/"); // the inner ones first
  }
  return (copy.textContent ?? "").replace(/\s+/g, " ").trim();
}

/** One side of a fraction on one line. @param {Element} side */
function grouped(side) {
  const text = (side.textContent ?? "").trim();
  return /[+−\-/·\s]/.test(text) ? `(${text})` : text;
}
