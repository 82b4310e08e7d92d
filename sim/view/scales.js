/** Round numbers for axes. */

import { exponent } from "./numbers.js";

export const STEP_SLACK = 1e-9; // of a step; nearer to a round number is rounding noise
const HEADROOM = 0.05; // of the values, above and below: no curve lies on the frame
const NOUGHT = 1e-12; // in SI units; what rounding leaves of nothing has no axis of its own

/** @typedef {{low: number, high: number, step: number}} Axis */

/** @param {Axis} axis @returns {number} decimals that tick labels need */
export function axisDecimals(axis) {
  return Math.max(0, -exponent(axis.step));
}

/** @param {Axis} axis @returns {number[]} the multiples of the step from low to high */
export function ticks(axis) {
  const first = Math.ceil(axis.low / axis.step - STEP_SLACK);
  const last = Math.floor(axis.high / axis.step + STEP_SLACK);
  const found = [];
  for (let k = first; k <= last; k += 1) found.push(k * axis.step);
  return found;
}

/** @param {number} value @returns {number} the smallest 1, 2, 5 times a power of ten above it */
export function niceAbove(value) {
  const power = Number(`1e${exponent(value)}`);
  for (const factor of [1, 2, 5]) {
    if (value <= factor * power * (1 + STEP_SLACK)) return factor * power;
  }
  return 10 * power;
}

/** @param {number} low @param {number} high @param {number} count @returns {Axis} covers zero too, with some room */
export function axis(low, high, count) {
  const bottom = low < -NOUGHT ? low : 0;
  const above = high > NOUGHT ? high : 0;
  const top = above === bottom ? 1 : above;
  const room = HEADROOM * (top - bottom);
  return { low: bottom - room, high: top + room, step: niceAbove((top - bottom) / count) };
}

/** @param {number} low @param {number} high @param {number} count @returns {Axis} from low to high exactly */
export function span(low, high, count) {
  return { low, high, step: niceAbove((high - low) / count) };
}
