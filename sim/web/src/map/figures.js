/** Values of a map as text. Twin of `value_text` in `sim/pages/map/figure.py`. */

import { decimalsFor, fixed } from "../../../view/numbers.js";

const SMALLER = 2; // decimals that small values may have more than the largest

/** Three figures; what is tiny beside the largest is nought. */
/** @param {number} value @param {number} most decimals @returns {string} */
export function figures(value, most) {
  const text = fixed(value, Math.min(decimalsFor(value || 1), most));
  return /[1-9]/.test(text) ? text : fixed(0, most - SMALLER);
}
