/** The scale of a map: bands between round numbers, fixed for all positions of its sliders. */

import { decimalsOf } from "../numbers.js";
import { niceAbove, STEP_SLACK } from "../scales.js";
import { diverging, sequential } from "./palette.js";

/** @typedef {import("./types.js").Scale} Scale */

const BANDS = 12; // at most about so many; more could not be told apart
const FLAT = 1e-9; // of the greatest value; a map that varies less is one band: rounding is not drawn

/** Bands that cover low to high. @param {number} low @param {number} high @returns {Scale} */
export function scaleFor(low, high) {
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const flat = high - low <= FLAT * largest || largest === 0;
  const step = flat ? (largest ? niceAbove(largest) : 1) : niceAbove((high - low) / BANDS);
  const first = Math.floor(low / step + STEP_SLACK);
  const last = Math.max(first + 1, Math.ceil(high / step - STEP_SLACK));
  const count = last - first;
  const centres = Array.from({ length: count }, (_, k) => (first + k + 0.5) * step);
  const around = Number(centres[0]) < 0 && Number(centres.at(-1)) > 0;
  return {
    low: first * step,
    step,
    count,
    colours: around ? diverging(centres) : sequential(count),
    zero: Math.min(count, Math.max(0, -first)),
  };
}

/** The numbers between the bands, and at both ends. @param {Scale} scale @returns {number[]} */
export function edges({ low, step, count }) {
  const first = Math.round(low / step);
  return Array.from({ length: count + 1 }, (_, k) => (first + k) * step);
}

/** Decimals that the numbers at the edges need. @param {Scale} scale */
export function edgeDecimals(scale) {
  return Math.max(...edges(scale).map((one) => decimalsOf(one)));
}
