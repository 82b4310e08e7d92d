/**
 * What a cart is drawn as. The box stays as large as its mass and keeps its colour; a skin adds lines
 * on it, and may take the wheels away or let it float. Its front is where it drives at the start.
 */

import { px } from "./numbers.js";

/** @typedef {import("./shapes.js").Box} Box */
/** @typedef {[number, number]} Point in widths of the box from its middle, + to the front, and in heights from the ground */
/** @typedef {{wheels: boolean, lift: number, corner: number, lines: (box: Box, front: 1 | -1) => string}} Skin `lift`: how high it floats, `corner`: radius; in units */

const NARROW = 24; // units: lines on a narrower box would hide its letter
const GAP = 5; // units of air below a glider
const SADDLE = 6; // units, the height of its foot

/** @type {Record<string, Skin>} */
export const SKINS = {
  cart: { wheels: true, lift: 0, corner: 4, lines: () => "" },
  van: { wheels: true, lift: 0, corner: 7, lines: van },
  truck: { wheels: true, lift: 0, corner: 3, lines: truck },
  trailer: { wheels: true, lift: 0, corner: 1, lines: trailer },
  box: { wheels: false, lift: 0, corner: 1, lines: crate },
  puck: { wheels: false, lift: 0, corner: 12, lines: puck },
  glider: { wheels: false, lift: GAP, corner: 4, lines: glider },
};

/** A slanted windscreen, a window behind, and a lamp. @param {Box} box @param {1 | -1} front */
function van(box, front) {
  return lines(box, front, [
    [
      [0.06, 0.9],
      [0.34, 0.9],
      [0.46, 0.68],
      [0.06, 0.68],
      [0.06, 0.9],
    ],
    [
      [-0.42, 0.9],
      [-0.08, 0.9],
      [-0.08, 0.68],
      [-0.42, 0.68],
      [-0.42, 0.9],
    ],
    [
      [0.4, 0.26],
      [0.5, 0.26],
    ],
  ]);
}

/** A cab with a window before a loading box. @param {Box} box @param {1 | -1} front */
function truck(box, front) {
  return lines(box, front, [
    [
      [0.22, 0],
      [0.22, 1],
    ],
    [
      [0.28, 0.9],
      [0.42, 0.9],
      [0.46, 0.66],
      [0.28, 0.66],
      [0.28, 0.9],
    ],
    [
      [-0.5, 0.16],
      [0.22, 0.16],
    ],
  ]);
}

/** Boards, and the frame below them. @param {Box} box @param {1 | -1} front */
function trailer(box, front) {
  return lines(box, front, [
    [
      [-0.5, 0.2],
      [0.5, 0.2],
    ],
    ...[-0.4, -0.27, 0.27, 0.4].map(
      (x) =>
        /** @type {Point[]} */ ([
          [x, 0.2],
          [x, 1],
        ]),
    ),
  ]);
}

/** A wooden box: a frame with a brace in every corner. @param {Box} box @param {1 | -1} front */
function crate(box, front) {
  return lines(box, front, [
    [
      [-0.4, 0.1],
      [0.4, 0.1],
      [0.4, 0.9],
      [-0.4, 0.9],
      [-0.4, 0.1],
    ],
    [
      [-0.4, 0.3],
      [-0.22, 0.1],
    ],
    [
      [0.4, 0.3],
      [0.22, 0.1],
    ],
    [
      [-0.4, 0.7],
      [-0.22, 0.9],
    ],
    [
      [0.4, 0.7],
      [0.22, 0.9],
    ],
  ]);
}

/** A disc seen from the side: the edges of its rim. @param {Box} box @param {1 | -1} front */
function puck(box, front) {
  return lines(box, front, [
    [
      [-0.48, 0.15],
      [0.48, 0.15],
    ],
    [
      [-0.48, 0.85],
      [0.48, 0.85],
    ],
  ]);
}

/** The saddle that sits over the rail of an air track, as long as the box. @param {Box} box @param {1 | -1} front */
function glider(box, front) {
  const top = Math.min(SADDLE / box.height, 0.4);
  return lines(box, front, [
    [
      [-0.5, top],
      [0.5, top],
    ],
    ...[-0.42, -0.28, 0.28, 0.42].map(
      (x) =>
        /** @type {Point[]} */ ([
          [x, 0],
          [x, top],
        ]),
    ),
  ]);
}

/** @param {Box} box @param {1 | -1} front @param {Point[][]} strokes @returns {string} path; empty on a narrow box */
function lines({ width, height }, front, strokes) {
  if (width < NARROW) return "";
  const at = (/** @type {Point} */ [x, y]) => `${px(front * x * width)} ${px(-y * height)}`;
  return strokes.map((points) => `M${points.map(at).join("L")}`).join("");
}
