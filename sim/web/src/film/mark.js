/**
 * The mark that a reader clicked on: where its middle is, how large it is, how far its colour is from what is
 * around it. Whoever hits a dot anywhere gets its middle, so that a second try gives the same readings.
 */

/** @typedef {import("./patch.js").Patch} Patch */
/** @typedef {{x: number, y: number, radius: number, contrast: number, colour: number[]}} Mark pixels of the frame */

export const LARGEST = 60; // pixels, radius of a mark
const LEAST = 14; // of 255: a mark that differs less from its surroundings cannot be told from noise
const SMALLEST = 1.5; // pixels
const TURNS = 4; // the middle is found anew from the middle found before
const CORNERS = 24; // places on a circle

/** @param {Patch} patch around the click @param {number} x @param {number} y of the frame @returns {Mark | null} null: nothing stands out here */
export function markAt(patch, x, y) {
  const colour = mean(patch, x, y, 1);
  let found = { x, y, radius: 0, contrast: 0 };
  for (let turn = 0; turn < TURNS; turn += 1) {
    const edge = edgeOf(patch, found.x, found.y, colour);
    if (edge.contrast < LEAST || edge.radius < SMALLEST) return null;
    const middle = middleOf(patch, found.x, found.y, edge, colour);
    if (!middle) return null;
    found = { ...middle, ...edge };
  }
  return { ...found, colour };
}

/** Distance of the colours on a circle from the mark's own, averaged. Its radius is where that is half of its greatest. */
/** @param {Patch} patch @param {number} x @param {number} y @param {number[]} colour */
function edgeOf(patch, x, y, colour) {
  const distances = [];
  for (let radius = 1; radius <= LARGEST; radius += 1) {
    let [sum, count] = [0, 0];
    for (let k = 0; k < CORNERS; k += 1) {
      const angle = (2 * Math.PI * k) / CORNERS;
      const at = index(patch, x + radius * Math.cos(angle), y + radius * Math.sin(angle));
      if (at < 0) continue;
      sum += distance(patch, at, colour);
      count += 1;
    }
    if (count < CORNERS / 2) break;
    distances.push(sum / count);
  }
  const contrast = Math.max(0, ...distances);
  const radius = 1 + distances.findIndex((one) => one > contrast / 2);
  return { contrast, radius };
}

/** The mean place of all pixels nearby that have the mark's colour. */
/** @param {Patch} patch @param {number} x @param {number} y @param {{radius: number, contrast: number}} edge @param {number[]} colour */
function middleOf(patch, x, y, { radius, contrast }, colour) {
  const far = 1.5 * radius + 2;
  let [sum, sx, sy] = [0, 0, 0];
  for (let row = Math.ceil(y - far); row <= y + far; row += 1) {
    for (let column = Math.ceil(x - far); column <= x + far; column += 1) {
      const at = index(patch, column, row);
      if (at < 0 || (column - x) ** 2 + (row - y) ** 2 > far * far) continue;
      // soft: a pixel on the edge counts half
      const weight = Math.max(0, 1 - distance(patch, at, colour) / contrast) ** 2;
      if (weight < 0.04) continue;
      sum += weight;
      sx += weight * column;
      sy += weight * row;
    }
  }
  return sum ? { x: sx / sum, y: sy / sum } : null;
}

/** @param {Patch} patch @param {number} x @param {number} y @param {number} reach */
function mean(patch, x, y, reach) {
  /** @type {number[]} */
  const places = [];
  for (let row = -reach; row <= reach; row += 1) {
    for (let column = -reach; column <= reach; column += 1) {
      const at = index(patch, x + column, y + row);
      if (at >= 0) places.push(at);
    }
  }
  return patch.channels.map(
    (channel) => places.reduce((sum, at) => sum + Number(channel[at]), 0) / (places.length || 1),
  );
}

/** @param {Patch} patch @param {number} x @param {number} y @returns {number} −1: outside */
function index(patch, x, y) {
  const [column, row] = [Math.round(x) - patch.left, Math.round(y) - patch.top];
  const inside = column >= 0 && row >= 0 && column < patch.width && row < patch.height;
  return inside ? row * patch.width + column : -1;
}

/** @param {Patch} patch @param {number} at @param {number[]} colour */
function distance(patch, at, colour) {
  let sum = 0;
  for (const [k, channel] of patch.channels.entries()) {
    sum += (Number(channel[at]) - Number(colour[k])) ** 2;
  }
  return Math.sqrt(sum);
}
