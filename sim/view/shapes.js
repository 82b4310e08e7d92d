/** Shapes of the world view as SVG attributes. */

import { isWord } from "./bodies.js";
import { px, short } from "./numbers.js";

/** @typedef {import("./types.js").Body} Body */
/** @typedef {import("./types.js").View} View */
/** @typedef {import("./types.js").Layout} Layout */
/** @typedef {{x: number, width: number, height: number, cut: boolean, nameY: number | null, label: string, labelY: number}} Box */

const REFERENCE_HEIGHT = 38;
const TALLEST = 4;
const LANE = 21;
const ABOVE = 33;
const DOT = 2.5; // radius of a zero force
const RING = 1; // radius of a zero velocity, drawn as a line
const SHORTEST = 0.5;
const LONGEST = 1.15; // full lengths of a force arrow, so that it stays in the picture
export const FASTEST = 2.2; // full lengths of a velocity arrow
const EDGE = 5; // units that a velocity arrow keeps from the edges of the picture
const TORN = 6; // units of the gap in an arrow that is cut
const LINE = 14;
const NAMED = 34;
const LETTER = 9.5; // units of width, of a word that is a name
const SPRING = [2, 10];
export const PUSH = 15.5;
const FACE = 22;
const WHEEL = 5.5; // units, its radius
const LIFT = -3; // units: labels of forces stand right below the track
const TURNS = 9; // of a coil
const LEAD = 5; // units of straight wire at each end of a coil
export const COIL = 7; // half its height

/** @param {Body} body @param {View} view @param {Layout} layout @param {number} i @param {string} [skin] whose lines a word would hide @returns {Box} area ∝ mass, or all alike */
export function box(body, view, layout, i, skin) {
  const lift = layout.stagger * (i % layout.ranks);
  const width = bodyWidth(body);
  const wanted = REFERENCE_HEIGHT * (view.alike ? 1 : body.mass / width / view.perHeight);
  const cut = wanted > TALLEST * REFERENCE_HEIGHT * (1 + 1e-9);
  const height = Math.min(wanted, TALLEST * REFERENCE_HEIGHT);
  const word = isWord(body.name) ? body.name.length * LETTER : 0;
  const named = height >= NAMED && (!word || (!skin && word < width * layout.scale));
  const mass = `${short(body.mass)} kg`;
  return {
    x: (-width * layout.scale) / 2,
    width: width * layout.scale,
    height,
    cut,
    nameY: named ? -(height + FACE) / 2 + 5 : null,
    label: named ? mass : `${body.name}: ${mass}`,
    labelY: named ? -height - 5 - lift : -Math.max(height, FACE) - 5 - lift,
  };
}

/** @param {Box} box @returns {string} the hubs of two wheels on the track: points that a round, thick line makes discs */
export function wheels({ width }) {
  const x = px(Math.max(width / 3, width / 2 - 1.5 * WHEEL));
  return `M-${x} ${LIFT}h0M${x} ${LIFT}h0`;
}

/** @param {Body} body @returns {number} length in m of its box, without bumpers */
export function bodyWidth(body) {
  return Math.max(body.length - 2 * body.bumper_length, 0.2 * body.length);
}

/** @param {number} i cart @param {number} tallest box @param {Layout} layout @returns {number} y of its velocity arrow */
export function lane(i, tallest, layout) {
  const above = Math.max(tallest, FACE) + layout.stagger * (layout.ranks - 1) + ABOVE;
  return layout.track - above - LANE * (layout.lanes - 1 - (i % layout.lanes));
}

/** @param {number} start @param {number} end @returns {string} a spring from the box to the bumper face */
export function spring(start, end) {
  const low = /** @type {number} */ (SPRING[0]);
  const high = /** @type {number} */ (SPRING[1]);
  const step = (end - start) / 4;
  let d = `M${px(start)} ${px(-(low + high) / 2)}`;
  for (let k = 0; k < 4; k += 1) {
    d += `L${px(start + (k + 0.5) * step)} ${px(k % 2 === 0 ? -high : -low)}`;
  }
  return `${d}L${px(end)} ${px(-(low + high) / 2)}`;
}

/** @param {number} start @param {number} end @param {number} y @returns {string} a wire of always the same turns */
export function coil(start, end, y, turns = TURNS, high = COIL) {
  const span = Math.max(0, end - start);
  const lead = Math.min(LEAD, span / 4);
  const step = (span - 2 * lead) / turns;
  let d = `M${px(start)} ${px(y)}L${px(start + lead)} ${px(y)}`;
  for (let k = 0; k < turns; k += 1) {
    d += `L${px(start + lead + (k + 0.5) * step)} ${px(k % 2 === 0 ? y - high : y + high)}`;
  }
  return `${d}L${px(start + span - lead)} ${px(y)}L${px(start + span)} ${px(y)}`;
}

/** @param {number} x @param {number} y @param {number} length @returns {string} force arrow, tail at (x, y) */
export function blockArrow(x, y, length) {
  if (Math.abs(length) < SHORTEST) return dot(x, y);
  const tip = x + length;
  const neck = tip - Math.sign(length) * Math.min(9, Math.abs(length));
  return (
    `M${px(x)} ${px(y - 3)}L${px(neck)} ${px(y - 3)}L${px(neck)} ${px(y - 6.5)}L${px(tip)} ${px(y)}` +
    `L${px(neck)} ${px(y + 6.5)}L${px(neck)} ${px(y + 3)}L${px(x)} ${px(y + 3)}Z`
  );
}

/** @param {number} x @param {number} y @param {number} length @returns {string} force arrow that is cut: with a gap */
export function cutArrow(x, y, length) {
  const half = length / 2 - (Math.sign(length) * TORN) / 2;
  const piece = `M${px(x)} ${px(y - 3)}h${px(half)}v6h${px(-half)}Z`;
  return piece + blockArrow(x + length - half, y, half);
}

/** @param {number} x @param {number} y @param {number} length @returns {string} velocity arrow: a line with an open head */
export function lineArrow(x, y, length) {
  if (Math.abs(length) < SHORTEST) return dot(x, y, RING);
  const tip = x + length;
  const back = tip - Math.sign(length) * Math.min(7, Math.abs(length));
  return (
    `M${px(x)} ${px(y)}L${px(tip)} ${px(y)}M${px(back)} ${px(y - 4.5)}L${px(tip)} ${px(y)}` +
    `L${px(back)} ${px(y + 4.5)}`
  );
}

/** @param {number} x @param {number} y @returns {string} a zero arrow */
export function dot(x, y, radius = DOT) {
  const [r, d] = [px(radius), px(2 * radius)];
  return `M${px(x - radius)} ${px(y)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 -${d} 0Z`;
}

/** @param {number} value @param {number} full scale @param {number} length of the full scale @returns {number} cut at the longest */
export function arrowLength(value, full, length, longest = LONGEST) {
  const exact = full ? (value / full) * length : 0;
  return Math.max(-longest * length, Math.min(longest * length, exact));
}

/** @param {number} value @param {number} full @returns {boolean} whether the arrow is cut: then its text says so */
export function isCut(value, full, longest = LONGEST) {
  return full > 0 && Math.abs(value) > longest * full;
}

/** @param {number} x @param {number} length @param {number} width @returns {[number, "start" | "end"]} where a velocity is written */
export function velocityText(x, length, width) {
  const room = 72;
  if (length >= 0) return x > room ? [x - 8, "end"] : [x + length + 8, "start"];
  return x < width - room ? [x + 8, "start"] : [x + length - 8, "end"];
}

/** @param {number} x @param {number} length @param {number} width @returns {number} length with the head in the picture; from outside as it was */
export function keptInside(x, length, width) {
  if (x > EDGE && x < width - EDGE) {
    if (x + length > width - EDGE) return width - EDGE - x;
    if (x + length < EDGE) return EDGE - x;
  }
  return length;
}

/** @param {Box} box @returns {number} top of the text above a box, relative to the track */
export function labelTop(box) {
  return box.labelY - LINE;
}
