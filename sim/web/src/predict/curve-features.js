/**
 * What is seen in a curve at one look, of a drawn one and of the run's: a shape is compared by its
 * features, never by its pixels. Heights are evenly spaced over the time.
 */

import { tr } from "../../../view/language.js";

const LITTLE = 0.05; // of the greatest height: smaller differences were not meant, and cannot be drawn

/** @typedef {[string, (heights: number[]) => boolean][]} Features */

/** @type {Record<"F" | "v" | "x", () => Features>} */
const FEATURES = { F: force, v: velocity, x: position };

/** @param {"F" | "v" | "x"} quantity @param {number[]} mine @param {number[]} run @returns {[string, boolean, boolean][]} feature, drawn, in the run */
export function features(quantity, mine, run) {
  return FEATURES[quantity]().map(([name, has]) => [name, has(mine), has(run)]);
}

/** @returns {Features} */
function force() {
  return [
    [tr("starts from zero"), (h) => none(h, 0)],
    [
      tr("is greatest in between"),
      (h) => Math.max(...h.slice(1, -1)) > Math.max(at(h, 0), at(h, -1)),
    ],
    [tr("goes up once and down once"), (h) => hills(h) === 1],
    [tr("is zero again at the end"), (h) => none(h, -1)],
  ];
}

/** @returns {Features} */
function velocity() {
  return [
    [tr("starts at rest"), (h) => none(h, 0)],
    [tr("stays the same from start to end"), (h) => Math.max(...h) - Math.min(...h) <= little(h)],
    [
      tr("is faster at the end than at the start"),
      (h) => Math.abs(at(h, -1)) - Math.abs(at(h, 0)) > little(h),
    ],
    [
      tr("changes evenly in the first half"),
      (h) => {
        const [first, second] = /** @type {[number, number]} */ (steps(h)); // with signs: up and down is no even change
        const least = Math.min(Math.abs(first), Math.abs(second));
        return least > little(h) && even([first, second], little(h));
      },
    ],
    [tr("stays the same in the last quarter"), (h) => Math.abs(at(steps(h), -1)) <= little(h)],
    [tr("turns round"), (h) => Math.max(...h) > little(h) && Math.min(...h) < -little(h)],
    [tr("is at rest at the end"), (h) => none(h, -1)],
  ];
}

/** @returns {Features} */
function position() {
  return [
    [tr("equal distances in equal times, all the way"), (h) => even(steps(h), little(h))],
    [
      tr("goes farther in the last quarter than in the first"),
      (h) => {
        const gone = steps(h).map(Math.abs);
        return at(gone, -1) - at(gone, 0) > little(h);
      },
    ],
    [
      tr("turns round"),
      (h) => Math.max(...steps(h)) > little(h) && Math.min(...steps(h)) < -little(h),
    ],
    [tr("stays where it is at the end"), (h) => Math.abs(at(steps(h), -1)) <= little(h)],
  ];
}

/** The change in each quarter of the time: of positions, the way gone. @param {number[]} h */
function steps(h) {
  const quarter = (h.length - 1) / 4;
  return [1, 2, 3, 4].map((k) => at(h, k * quarter) - at(h, (k - 1) * quarter));
}

/** @param {number[]} gone @param {number} little */
function even(gone, little) {
  return Math.max(...gone) - Math.min(...gone) <= little;
}

/** @param {number[]} h @param {number} k */
function none(h, k) {
  return Math.abs(at(h, k)) <= little(h);
}

/** @param {number[]} h */
function little(h) {
  return LITTLE * Math.max(...h.map(Math.abs));
}

/** @param {number[]} h @param {number} k from the end where negative */
function at(h, k) {
  return h.at(k) ?? 0;
}

/** @param {number[]} heights @returns {number} how often they go up and then down */
function hills(heights) {
  let found = 0;
  let rising = false;
  heights.forEach((height, k) => {
    const before = heights[k - 1] ?? 0;
    if (height > before) rising = true;
    if (height < before && rising) {
      found += 1;
      rising = false;
    }
  });
  return found + (rising ? 1 : 0);
}
