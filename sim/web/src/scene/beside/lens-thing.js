/** What stands at an end of the track instead of a wall, through the lens: it fills the drawing from top to track. */

import { bubbles } from "../../../../view/deformation/bubbles.js";
import { px } from "../../../../view/numbers.js";
import { coil } from "../../../../view/shapes.js";
import { need, put, svg } from "../../shared/dom.js";

/** @typedef {{end: number, was: number, out: 1 | -1, depth: number}} Thing `end`: x of its face, `was`: where that is while nothing pushes, `out`: 1 where it stands on the right, `depth` from there to its mounting; in units of the lens */

const TOP = 22; // y, as of the carts
const FOOT = 88;
const ARM = 12; // units of the mounting that a board hangs from
const THICK = /** @type {Record<string, number>} */ ({ spring: 12, board: 24 }); // units of what is touched
const SOLID = 12; // units that are left of what is squeezed most
const FAR = 720; // units: the mounting has no other side
const PITCH = 16; // units between two turns of a spring
const HIGH = 20; // units, half the height of its coil
const BUBBLE = 1.4; // times as large as in the picture

/** Draws it in place of a wall; a wall has none of it. @param {Element} group of one side @param {string} what @param {Thing} thing */
export function drawThing(group, what, thing) {
  const rect = need(group, '[data-part="body"]');
  const parts = ["mounting", "thing"].map((name) => group.querySelector(`[data-part="${name}"]`));
  if (what === "wall") {
    for (const part of parts) part?.remove();
    put(rect, "width", String(FAR));
    return;
  }
  const [mounting, lines] = parts[0] && parts[1] ? parts : added(rect);
  const { end, was, out, depth } = thing;
  const back = was + out * Math.max(depth, Math.abs(end - was) + (THICK[what] ?? 0) + SOLID);
  const thick = THICK[what] ?? Math.abs(back - end);
  put(rect, "x", px(out > 0 ? end : end - thick));
  put(rect, "width", px(thick));
  const behind = end + out * thick;
  const from =
    what === "board" ? `M${px(back)} ${TOP + ARM}H${px(behind)}V${TOP}` : `M${px(back)} ${TOP}`;
  put(/** @type {Element} */ (mounting), "d", `${from}h${out * FAR}V${FOOT}H${px(back)}Z`);
  put(/** @type {Element} */ (lines), "class", what === "spring" ? "carts-coil" : "carts-fine");
  put(/** @type {Element} */ (lines), "d", inside(what, { ...thing, back, behind }));
}

/** @param {string} what @param {Thing & {back: number, behind: number}} place @returns {string} thin lines */
function inside(what, { end, depth, back, behind }) {
  if (what === "board") return `M${px((end + behind) / 2)} ${TOP}V${FOOT}`;
  if (what === "foam") return bubbles(() => end, back, depth, [TOP, FOOT], BUBBLE);
  const [low, high] = [Math.min(behind, back), Math.max(behind, back)];
  return coil(low, high, (TOP + FOOT) / 2, Math.round(depth / PITCH), HIGH);
}

/** @param {Element} rect @returns {[Element, Element]} mounting and lines, behind what else stands there */
function added(rect) {
  const mounting = svg("path", { "data-part": "mounting", class: "carts-box" });
  const lines = svg("path", { "data-part": "thing" });
  rect.after(mounting, lines);
  return [mounting, lines];
}
