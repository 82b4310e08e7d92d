/** Bubbles of foam: in rows, and squeezed with it. */

import { px } from "../numbers.js";

const APART = 13; // units between two
const RADIUS = 3.5; // units
const SMALL = 0.6; // of that, every third

/**
 * @param {(y: number) => number} front x of the face at a height @param {number} back x where the foam ends
 * @param {number} depth units from face to end while nothing pushes @param {[number, number]} heights y of its top and foot @param {number} size times as large as in the picture
 * @returns {string} a path
 */
export function bubbles(front, back, depth, [top, foot], size = 1) {
  const columns = Math.max(2, Math.round(depth / (APART * size)));
  const rows = Math.max(2, Math.floor((foot - top) / (APART * size)));
  let d = "";
  for (let row = 0; row < rows; row += 1) {
    const y = top + ((row + 0.5) * (foot - top)) / rows;
    const room = back - front(y);
    const squeezed = Math.min(1, Math.abs(room) / depth);
    for (let column = 0; column < columns; column += 1) {
      const x = front(y) + (room * (column + (row % 2 ? 0.7 : 0.3))) / columns;
      d += bubble(x, y, size * RADIUS * ((row + column) % 3 ? 1 : SMALL), squeezed);
    }
  }
  return d;
}

/** @param {number} x @param {number} y @param {number} radius @param {number} squeezed what is left of its width, 1: all */
function bubble(x, y, radius, squeezed) {
  const wide = px(radius * squeezed);
  const across = px(2 * radius * squeezed);
  const half = `a${wide} ${px(radius)} 0 1 0`;
  return `M${px(x - Number(wide))} ${px(y)}${half} ${across} 0${half} -${across} 0`;
}
