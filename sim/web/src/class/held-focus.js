/** Parts of the page are made anew when something changes: who works by keys stays where they were. */

const BY_KEYS = "button, input:not([hidden]), select, textarea, summary";

/** @param {HTMLElement} root @param {() => void} draw */
export function holdingFocus(root, draw) {
  const places = () => [.../** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll(BY_KEYS))];
  const held = /** @type {HTMLElement} */ (document.activeElement);
  const at = places().indexOf(held);
  draw();
  if (at >= 0 && !held.isConnected) places()[at]?.focus({ preventScroll: true });
}
