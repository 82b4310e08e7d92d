/**
 * Finds in a piece of a frame the place where it looks most like a mark.
 *
 * The template is the mark with a rim, cut from the frame in which it was clicked. At a place of the search the
 * distance of the two pictures is the sum of squares of the differences in colour, each cut off where it says
 * no more than “something else”: what lies behind the rim may change. The search first goes in coarse steps with
 * few pixels, then in whole pixels, and at last takes the least of the parabola through the neighbours.
 */

import { clamp } from "./clamp.js";
import { boxAround, value } from "./patch.js";

/** @typedef {import("./patch.js").Patch} Patch */
/** @typedef {import("./patch.js").Box} Box */
/**
 * @typedef {{half: number, step: number, most: number, dx: number, dy: number, channels: Float32Array[], own: number[]}} Template
 *   a square of 2 half + 1 pixels; its middle lies (dx, dy) beside the mark's. `most`: where differences are cut off;
 *   `own`: pixels of it that have the mark's colour
 * @typedef {{x: number, y: number, alike: number}} Found alike: of the mark's own pixels; 1 the same, 0 nothing of it
 */

const RIM = 1.5; // the template reaches so many radii
const [LEAST, MOST] = [4, 40]; // pixels, half of a template
const COARSE = 4; // pixels of the template to each side in the first search
const CUT = 0.7; // of the contrast
const FAR = 0.2; // what a place at the border of the search has to be better by

/** @param {Patch} patch @param {import("./mark.js").Mark} mark @returns {Template} */
export function templateOf(patch, mark) {
  const half = Math.round(Math.min(MOST, Math.max(LEAST, RIM * mark.radius)));
  const [x, y] = [Math.round(mark.x), Math.round(mark.y)];
  const side = 2 * half + 1;
  const channels = patch.channels.map((channel) => {
    const cut = new Float32Array(side * side);
    for (let row = -half; row <= half; row += 1) {
      for (let column = -half; column <= half; column += 1) {
        const at = inside(y + row - patch.top, patch.height) * patch.width;
        const from = at + inside(x + column - patch.left, patch.width);
        cut[(row + half) * side + column + half] = value(channel, from);
      }
    }
    return cut;
  });
  const step = Math.max(1, Math.floor(half / COARSE));
  const most = (CUT * mark.contrast) ** 2;
  const own = ownOf(channels, mark);
  return { half, step, most, dx: mark.x - x, dy: mark.y - y, channels, own };
}

/** @param {Float32Array[]} channels @param {import("./mark.js").Mark} mark @returns {number[]} */
function ownOf(channels, { colour, contrast }) {
  const near = (/** @type {number} */ at) =>
    channels.reduce((sum, channel, k) => sum + (value(channel, at) - value(colour, k)) ** 2, 0);
  const all = Array.from(channels[0] ?? [], (_, at) => at);
  return all.filter((at) => near(at) < (contrast / 2) ** 2);
}

/** How much of the mark itself is to be seen here. @param {Patch} patch @param {Template} template @param {{x: number, y: number}} place */
function alikeAt(patch, { half, most, channels, own }, { x, y }) {
  const side = 2 * half + 1;
  let sum = 0;
  for (const at of own) {
    const from = (y - half + Math.floor(at / side)) * patch.width + x - half + (at % side);
    let one = 0;
    for (const [k, channel] of channels.entries()) {
      one += (value(patch.channels[k] ?? [], from) - value(channel, at)) ** 2;
    }
    sum += Math.min(one, most);
  }
  return own.length ? 1 - sum / (own.length * most) : 0;
}

/** @param {number} k @param {number} count */
const inside = (k, count) => clamp(k, 0, count - 1);

/**
 * The place in the patch that is most like the template; of two that are alike the one nearer to (x, y).
 * @param {Patch} patch @param {Template} template @param {number} x where it is expected @param {number} y
 * @returns {Found | null} null: the patch is too small
 */
export function find(patch, template, x, y) {
  const { half, step } = template;
  const [low, high] = [half, { x: patch.width - 1 - half, y: patch.height - 1 - half }];
  if (high.x < low || high.y < low) return null;
  const [ex, ey] = [x - template.dx - patch.left, y - template.dy - patch.top];
  const far = (patch.width / 2) ** 2 + (patch.height / 2) ** 2;
  const all = { left: low, top: low, right: high.x, bottom: high.y };
  const beside = (/** @type {number} */ column, /** @type {number} */ row) =>
    (FAR * ((column - ex) ** 2 + (row - ey) ** 2)) / far;
  const coarse = least(all, step, (column, row) => {
    return beside(column, row) + distance(patch, template, column, row, step);
  });
  const middle = least(within(all, coarse, step), Math.ceil(step / COARSE), (column, row) => {
    return distance(patch, template, column, row, step);
  });
  const near = least(within(all, middle, Math.ceil(step / COARSE)), 1, (column, row) => {
    return distance(patch, template, column, row, 1);
  });
  const shift = between(patch, template, near, low, high);
  return {
    x: patch.left + near.x + shift.x + template.dx,
    y: patch.top + near.y + shift.y + template.dy,
    alike: alikeAt(patch, template, near),
  };
}

/** @typedef {{left: number, top: number, right: number, bottom: number}} Span of places, both ends belong to it */

/** The part of a span that is at most `reach` from a place. @param {Span} all @param {{x: number, y: number}} place @param {number} reach @returns {Span} */
function within(all, { x, y }, reach) {
  return {
    left: Math.max(all.left, x - reach),
    top: Math.max(all.top, y - reach),
    right: Math.min(all.right, x + reach),
    bottom: Math.min(all.bottom, y + reach),
  };
}

/** The place with the least cost. @param {Span} span @param {number} step @param {(x: number, y: number) => number} costs */
function least({ left, top, right, bottom }, step, costs) {
  let best = { x: left, y: top, cost: Infinity };
  for (let y = top; y <= bottom; y += step) {
    for (let x = left; x <= right; x += step) {
      const cost = costs(x, y);
      if (cost < best.cost) best = { x, y, cost };
    }
  }
  return best;
}

/** From 0, the same, to 1: nothing of it. @param {Patch} patch @param {Template} template @param {number} x of the middle @param {number} y @param {number} step */
function distance(patch, { half, most, channels }, x, y, step) {
  const side = 2 * half + 1;
  const [a, b, c] = /** @type {[Float32Array, Float32Array, Float32Array]} */ (patch.channels);
  const [ta, tb, tc] = /** @type {[Float32Array, Float32Array, Float32Array]} */ (channels);
  const first = half % step;
  let [sum, count] = [0, 0];
  for (let row = first; row < side; row += step) {
    const from = (y - half + row) * patch.width + x - half;
    for (let column = first; column < side; column += step) {
      const at = from + column;
      const own = row * side + column;
      const da = value(a, at) - value(ta, own);
      const db = value(b, at) - value(tb, own);
      const dc = value(c, at) - value(tc, own);
      const one = da * da + db * db + dc * dc;
      sum += one < most ? one : most;
      count += 1;
    }
  }
  return sum / (count * most);
}

/** How far beside the best whole pixel the least of the distance lies, along x and y. */
/** @param {Patch} patch @param {Template} template @param {{x: number, y: number, cost: number}} best @param {number} low @param {{x: number, y: number}} high */
function between(patch, template, best, low, high) {
  const at = (/** @type {number} */ dx, /** @type {number} */ dy) =>
    distance(patch, template, best.x + dx, best.y + dy, 1);
  const along = (/** @type {number} */ before, /** @type {number} */ after) => {
    const bend = before + after - 2 * best.cost;
    return bend > 0 ? clamp((before - after) / (2 * bend), -0.5, 0.5) : 0;
  };
  const free = { x: best.x > low && best.x < high.x, y: best.y > low && best.y < high.y };
  return {
    x: free.x ? along(at(-1, 0), at(1, 0)) : 0,
    y: free.y ? along(at(0, -1), at(0, 1)) : 0,
  };
}

/** The piece of the frame that has to be looked at so that the mark is found anywhere within (across, up) of (x, y). */
/** @param {Template} template @param {number} x @param {number} y @param {number} across @param {number} up @param {{width: number, height: number}} picture @returns {Box} */
export function searched({ half }, x, y, across, up, picture) {
  return boxAround(x, y, across + half + 1, up + half + 1, picture);
}
