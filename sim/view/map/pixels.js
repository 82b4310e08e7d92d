/**
 * The picture of a map: bands of colour with a darker edge. Between the points of the grid it is drawn with
 * straight lines; beside a point without a value each point keeps to itself.
 */

import { STEP_SLACK } from "../scales.js";
import { edge, NONE, ZERO } from "./palette.js";

/** @typedef {import("./types.js").Scale} Scale */
/** @typedef {import("./types.js").Grid} Grid */

const FINE = 400; // pixels along the longer side, at least

/** @param {number} value @param {Scale} scale @returns {number} count where there is no value */
function band(value, { low, step, count }) {
  if (Number.isNaN(value)) return count;
  const place = Math.floor((value - low) / step + STEP_SLACK);
  return Math.min(count - 1, Math.max(0, place));
}

/** @param {number} a @param {number} b @param {number} part @returns {number} where a value is missing, the nearer */
function mixed(a, b, part) {
  if (Number.isNaN(a) || Number.isNaN(b)) return part < 0.5 ? a : b;
  return a * (1 - part) + b * part;
}

/**
 * Each of `lines` lines of `count` values with more points in between, one after the other.
 * @param {ArrayLike<number>} values @param {number} lines @param {number} count @param {number} factor
 * @param {number} next from a value to the next @param {number} line from a line to the next
 */
function between(values, lines, count, factor, next, line) {
  const fine = (count - 1) * factor + 1;
  const found = new Float64Array(lines * fine);
  for (let i = 0; i < lines; i += 1) {
    for (let k = 0; k < fine; k += 1) {
      const left = Math.min(Math.floor(k / factor), count - 2);
      const at = i * line + left * next;
      const part = (k - left * factor) / factor;
      found[i * fine + k] = mixed(Number(values[at]), Number(values[at + next]), part);
    }
  }
  return found;
}

/**
 * Colour numbers of the picture, the top row first: bands, no value, from count + 1 on the bands'
 * edges, and last the line of zero.
 * @param {ArrayLike<number>} values @param {number} columns @param {Scale} scale
 * @returns {{places: Uint8Array, width: number, height: number}}
 */
export function pixels(values, columns, scale) {
  const rows = values.length / columns;
  const factor = Math.max(1, Math.ceil(FINE / (Math.max(columns, rows) - 1)));
  const width = (columns - 1) * factor + 1;
  const height = (rows - 1) * factor + 1;
  const wide = between(values, rows, columns, factor, 1, columns); // row after row
  const fine = between(wide, width, rows, factor, width, 1); // column after column, from below
  const bands = new Uint8Array(width * height);
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      bands[y * width + x] = band(Number(fine[x * height + (height - 1 - y)]), scale);
    }
  }
  return { places: lines(bands, width, scale), width, height };
}

/**
 * The bands with their edges, and the line of zero, twice as broad.
 * @param {Uint8Array} bands @param {number} width @param {Scale} scale @returns {Uint8Array}
 */
function lines(bands, width, { count, zero }) {
  const places = bands.slice();
  const line = 2 * count + 1;
  const compare = (/** @type {number} */ at, /** @type {number} */ other) => {
    const own = Number(bands[at]);
    const next = Number(bands[other]);
    if (next === own || own === count) return;
    if (next !== count && own >= zero !== next >= zero) {
      places[at] = line;
      places[other] = line;
    } else if (places[at] !== line) places[at] = count + 1 + own;
  };
  for (let at = 0; at < bands.length; at += 1) {
    if ((at + 1) % width) compare(at, at + 1);
    if (at + width < bands.length) compare(at, at + width);
  }
  return places;
}

/** The colours that the picture's numbers stand for. @param {Scale} scale @returns {import("./palette.js").Colour[]} */
export function palette({ colours }) {
  return [...colours, NONE, ...colours.map(edge), ZERO];
}
