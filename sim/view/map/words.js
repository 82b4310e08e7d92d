/** Values and points of a map as text. */

import { tr } from "../language.js";
import { decimalsFor, decimalsOf, fixed } from "../numbers.js";

/** @typedef {import("./types.js").Axis} Axis */
/** @typedef {import("./types.js").MapFacts} MapFacts */

const SMALLER = 2; // decimals that small values may have more than the largest
const EXACT = 12; // digits without the rounding of a conversion

/** Three figures; what is tiny beside the largest is nought. @param {number} value @param {Pick<MapFacts, "low" | "high">} facts @returns {string} */
export function valueText(value, { low, high }) {
  if (Number.isNaN(value)) return tr("no value");
  const most = decimalsFor(Math.max(Math.abs(low), Math.abs(high)) || 1) + SMALLER;
  const text = fixed(value, Math.min(decimalsFor(value || 1), most));
  return /[1-9]/.test(text) ? text : fixed(0, most - SMALLER);
}

/** @param {number} value SI @param {Axis} axis @returns {number} in the axis's unit */
export function shown(value, { per }) {
  return Number((value / per).toPrecision(EXACT));
}

/** Decimals that tell the points of an axis apart. @param {Axis} axis */
export function axisDecimals(axis) {
  const [first = 0, second = 0] = axis.values.map((value) => shown(value, axis));
  return Math.max(decimalsOf(first), decimalsOf(second - first, 3));
}

/** @param {{label: string, unit: string}} of a number @returns {string} its name with its unit */
export function named({ label, unit }) {
  return unit ? tr("{label} in {unit}", { label, unit }) : label;
}
