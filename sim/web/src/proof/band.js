/** What tolerances allow, as a pale band behind the curves of places and velocities. */

import { timeX, valueY } from "../../../view/graph.js";
import { styleOf } from "../../../view/markers.js";
import { px } from "../../../view/numbers.js";
import { svg } from "../shared/dom.js";

/** @typedef {import("../../../view/graph.js").Plane} Plane */
/** @typedef {[number, number][]} Bounds */
/** @typedef {{t: number[], x: Record<string, Bounds>, v: Record<string, Bounds>}} Band SI units */

/**
 * Takes the band out of a graph, and draws it anew where there is one.
 * @param {Band | null} band @param {import("../scene/graphs/graph-view.js").GraphView} graph @param {Plane} plane
 */
export function drawBand(band, { root, quantity, per, camera }, plane) {
  root.querySelector('[data-part="band"]')?.remove();
  if (!band || (quantity !== "x" && quantity !== "v")) return;
  const seen = (/** @type {number} */ value, /** @type {number} */ t) =>
    quantity === "x" ? value - camera * t : (value - camera) / per;
  const front = root.querySelector('[data-part="curves"]');
  const clip = front?.getAttribute("clip-path") ?? "none";
  const group = svg("g", { "data-part": "band", "clip-path": clip, "aria-hidden": "true" });
  Object.values(band[quantity]).forEach((bounds, cart) => {
    const d = outline(bounds, band.t, plane, seen);
    group.append(svg("path", { class: `carts-band carts-${styleOf(cart)}`, d }));
  });
  front?.before(group);
}

/**
 * Along the upper bounds, and back along the lower ones.
 * @param {Bounds} bounds @param {number[]} times in s @param {Plane} plane @param {(value: number, t: number) => number} seen
 */
function outline(bounds, times, plane, seen) {
  const at = (/** @type {number} */ k, /** @type {0 | 1} */ side) => {
    const t = Number(times[k]);
    return `${px(timeX(plane, t))} ${px(valueY(plane, seen(bounds[k]?.[side] ?? 0, t)))}`;
  };
  const order = bounds.map((_, k) => k);
  const up = order.map((k) => at(k, 1));
  const down = order.reverse().map((k) => at(k, 0));
  return `M${[...up, ...down].join("L")}Z`;
}
