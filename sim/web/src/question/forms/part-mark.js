/** What marking says beside one part of an answer: a cell of a table, a pair. Which parts are right, never what would be. */

import { tr } from "../../../../view/language.js";

/** @param {HTMLElement} place @param {"right" | "wrong" | ""} verdict */
export function mark(place, verdict) {
  const sign = /** @type {HTMLElement} */ (place.querySelector(".carts-q-cell-mark"));
  const words = { right: tr("right"), wrong: tr("not yet"), "": "" };
  place.dataset.verdict = verdict;
  sign.textContent = verdict && (verdict === "right" ? "✓ " : "✗ ") + words[verdict];
}
