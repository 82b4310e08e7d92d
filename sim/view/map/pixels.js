/**
 * The picture of a map: bands of colour with a darker edge. Between the points of the grid it is drawn with
 * straight lines; where values jump, and beside a point without one, each point keeps to itself.
 */

import { STEP_SLACK } from "../scales.js";
import { edge, NONE, ZERO } from "./palette.js";

/** @typedef {import("./types.js").Scale} Scale */
/** @typedef {import("./types.js").Grid} Grid */

const FINE = 400; // pixels along the longer side, at least
const TORN = 3; // bands from a point to the next, and times what it is on the calmer side of them: a jump

/** @param {number} value @param {Scale} scale @returns {number} count where there is no value */
function band(value, { low, step, count }) {
  if (Number.isNaN(value)) return count;
  const place = Math.floor((value - low) / step + STEP_SLACK);
  return Math.min(count - 1, Math.max(0, place));
}

/**
 * Whether there is no line from a to b: a value is missing, or they differ far more than their neighbours do.
 * @param {number} before @param {number} a @param {number} b @param {number} after @param {number} step
 */
export function torn(before, a, b, after, step) {
  const apart = Math.abs(b - a);
  if (apart <= TORN * step) return false; // nearly all: a large map asks this at every gap of every line
  const beside = [a - before, b - after].map(Math.abs).filter(Number.isFinite); // none beyond an end
  return !(apart <= TORN * (beside.length ? Math.min(...beside) : apart));
}

/**
 * Each of `lines` lines of `count` values with more points in between, one after the other.
 * @param {ArrayLike<number>} values @param {number} lines @param {number} count @param {number} factor
 * @param {number} next from a value to the next @param {number} line from a line to the next @param {number} step of a band
 */
function between(values, lines, count, factor, next, line, step) {
  const fine = (count - 1) * factor + 1;
  const found = new Float64Array(lines * fine);
  for (let i = 0; i < lines; i += 1) {
    const value = (/** @type {number} */ k) =>
      k < 0 || k >= count ? Number.NaN : Number(values[i * line + k * next]);
    for (let left = 0; left < count - 1; left += 1) {
      const [a, b] = [value(left), value(left + 1)];
      const apart = torn(value(left - 1), a, b, value(left + 2), step);
      for (let k = 0; k <= factor; k += 1) {
        const part = k / factor;
        const mixed = a * (1 - part) + b * part;
        found[i * fine + left * factor + k] = !apart ? mixed : part < 0.5 ? a : b;
      }
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
  const wide = between(values, rows, columns, factor, 1, columns, scale.step); // row after row
  const fine = between(wide, width, rows, factor, width, 1, scale.step); // column after column, from below
  const bands = new Uint8Array(width * height);
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      bands[y * width + x] = band(Number(fine[x * height + (height - 1 - y)]), scale);
    }
  }
  return { places: lines(bands, width, scale), width, height };
}

/**
 * The bands with their edges, and the line of zero, twice as broad; a jump across zero is an edge.
 * @param {Uint8Array} bands @param {number} width @param {Scale} scale @returns {Uint8Array}
 */
function lines(bands, width, { count, zero }) {
  const places = bands.slice();
  const line = 2 * count + 1;
  const compare = (/** @type {number} */ at, /** @type {number} */ other) => {
    const own = Number(bands[at]);
    const next = Number(bands[other]);
    if (next === own || own === count) return;
    if (next !== count && own >= zero !== next >= zero && Math.abs(own - next) === 1) {
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
