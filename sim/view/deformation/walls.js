/** The outline of a wall. Where a cart without bumpers runs into it, the wall gives way and is drawn so. */

import { px } from "../numbers.js";

/** @typedef {import("../types.js").Layout} Layout */
/** @typedef {{edge: number, way: 1 | -1, top: number}} Wall `edge`: x of its face when nothing pushes it, `way`: 1 where it stands on the right; in units of the picture */

const LEAST = 64; // units above the track
export const THICK = 2000; // units: it has no other side
export const ROOM = 3; // units between the top of a cart and the part of the face that gives way
export const SEEN = 1; // units: a smaller dent has no line where the face was

/** @param {"left" | "right"} side @param {number | null} length of the track in m @param {Layout} layout @param {number} tallest box @returns {Wall} */
export function wallAt(side, length, layout, tallest) {
  const x = side === "left" ? 0 : Number(length);
  const edge = layout.origin + x * layout.scale;
  return { edge, way: side === "left" ? -1 : 1, top: layout.track - Math.max(tallest, LEAST) };
}

/**
 * @param {Wall} wall @param {Layout} layout @param {number} dent how far it gives way @param {number} height of the cart that presses
 * @returns {{body: string, face: string, was: string}} paths; `was`: where the face stood, "" where it stands there
 */
export function wallPaths({ edge, way, top }, { track, beam }, dent, height) {
  const high = Math.max(top, track - height - ROOM);
  const shoulder = Math.max(top, high - dent);
  const pressed = `V${px(shoulder)}L${px(edge + way * dent)} ${px(high)}V${px(track)}H${px(edge)}`;
  const face = `M${px(edge)} ${px(top)}${dent > 0 ? pressed : ""}V${px(track + beam)}`;
  const was = dent < SEEN ? "" : `M${px(edge)} ${px(shoulder)}V${px(track)}`;
  return { body: `${face}h${way * THICK}V${px(top)}Z`, face, was };
}
