/** The words on the pad of a curve stand where no curve goes through them: struck out they say the opposite. */

import { px } from "../../../view/numbers.js";
import { LEFT, POINTS, STEP } from "../../../view/pad.js";

const INSET = 6; // units from the line of a point to words that begin there
/** Rows for the words of each way: from and to in steps of height, and the line they are written on. @type {Record<string, [number, number, number][]>} */
const ROWS = {
  1: [
    [6.6, 10, 24],
    [3.7, 6.6, 44],
  ],
  0: [
    [0.5, 3.7, 61],
    [-3.7, -0.5, 87],
  ],
  "-1": [
    [-10, -6.6, 126],
    [-6.6, -3.7, 107],
  ],
};

/** @param {SVGSVGElement} pad @param {ArrayLike<number>[]} curves heights evenly over the time, their number a multiple of four and one */
export function placeLabels(pad, curves) {
  for (const text of pad.querySelectorAll("[data-way]")) {
    const way = text.getAttribute("data-way") ?? "";
    const middle = way === "0";
    const gaps = Array.from({ length: POINTS - 1 }, (_, k) => (middle ? POINTS - 2 - k : k));
    const rows = ROWS[way] ?? [];
    const places = middle
      ? gaps.flatMap((gap) => rows.map((row) => ({ gap, row })))
      : rows.flatMap((row) => gaps.map((gap) => ({ gap, row })));
    const free = places.find(({ gap, row: [low, high] }) =>
      curves.every((heights) => !crosses(heights, gap, low, high)),
    );
    const { gap, row } = free ?? /** @type {typeof places[0]} */ (places[0]);
    text.setAttribute("x", px(LEFT + STEP * gap + (middle ? STEP / 2 : INSET)));
    text.setAttribute("y", String(row[2]));
  }
}

/** @param {ArrayLike<number>} heights @param {number} gap between two points @param {number} low @param {number} high */
function crosses(heights, gap, low, high) {
  const per = (heights.length - 1) / (POINTS - 1);
  const within = Array.from(heights).slice(gap * per, (gap + 1) * per + 1);
  return Math.max(...within) > low && Math.min(...within) < high;
}
