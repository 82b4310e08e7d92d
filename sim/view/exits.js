/** When carts leave the picture at an open end. */

import { valueAt } from "./trajectory.js";

/** @typedef {{t: number, name: string, side: "left" | "right", velocity: number}} Exit */

const HALVINGS = 40;

/**
 * First time that each cart is wholly outside the picture; velocities as the camera sees them.
 * @param {import("./types.js").Run} run @param {import("./types.js").Layout} layout @param {number} camera in m/s
 * @returns {Exit[]}
 */
export function exits({ header, trajectory }, { low, high }, camera) {
  const { t: times, x: places, v, a } = trajectory;
  /** @type {Exit[]} */
  const found = [];
  for (const { name, length } of header.bodies) {
    const half = length / 2;
    const place = (/** @type {number} */ t) =>
      valueAt(times, places[name] ?? [], v[name] ?? [], t) - camera * t;
    const isOut = (/** @type {number} */ t) =>
      Math.max(place(t) - half - high, low - place(t) - half) > 0;
    const row = Array.prototype.findIndex.call(times, isOut);
    if (row < 1) continue;
    let before = Number(times[row - 1]);
    let after = Number(times[row]);
    for (let k = 0; k < HALVINGS; k += 1) {
      const middle = (before + after) / 2;
      if (isOut(middle)) after = middle;
      else before = middle;
    }
    const velocity = valueAt(times, v[name] ?? [], a[name] ?? [], after) - camera;
    found.push({ t: after, name, side: place(after) > high ? "right" : "left", velocity });
  }
  return found;
}
