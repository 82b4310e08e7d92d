/**
 * The mean force of each contact that can be found from m Δv/Δt: the impulse of the contact over its
 * time. Where another force acts meanwhile, m Δv is not that impulse, and nobody is asked for it.
 */

import { isWall } from "../../../view/bodies.js";
import { valueAt } from "../../../view/trajectory.js";
import { touches } from "../../../view/windows.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/windows.js").Touch} Touch */
/** @typedef {{cart: string, other: string, value: number, start: number, end: number}} Mean value: N, + to the right; from start to end in s */

const ALONE = 0.02; // of the impulse: by more m Δv differs where another force acts too

/** The mean contact force on each cart, of the first contact of each pair that can be found. @param {Run} run @returns {Mean[]} */
export function meanForces(run) {
  /** @type {Mean[]} */
  const found = [];
  for (const touch of ended(run)) {
    const { bodies, start, end } = touch;
    const impulse = impulseOf(run, touch);
    const carts = bodies.filter((name) => !isWall(name));
    const whole = (/** @type {string} */ cart) => (cart === bodies[0] ? -impulse : impulse);
    if (!impulse || !carts.every((cart) => isAlone(run, touch, cart, whole(cart)))) continue;
    for (const cart of carts) {
      const other = String(bodies.find((name) => name !== cart));
      if (found.some((one) => one.cart === cart && one.other === other)) continue;
      found.push({ cart, other, value: whole(cart) / (end - start), start, end });
    }
  }
  return found;
}

/** Whether two touch and part. @param {Run} run */
export function anyTouch(run) {
  return ended(run).length > 0;
}

/** @param {Run} run @param {string} name */
export function massOf({ header }, name) {
  return header.bodies.find((one) => one.name === name)?.mass ?? 0;
}

/** @param {Run} run @param {string} name @param {number} t in s @returns {number} m/s */
export function velocity({ trajectory }, name, t) {
  return valueAt(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], t);
}

/** @param {Run} run */
function ended({ header }) {
  return touches(header.events, header.until).filter(
    ({ end, lasts }) => !lasts && end < header.until,
  );
}

/** N s, from the first touch to the end. @param {Run} run @param {Touch} touch */
function impulseOf({ header }, { pair, end }) {
  const all = header.events.filter(({ t, bodies }) => t === end && bodies.join("-") === pair);
  return Math.max(0, ...all.map(({ impulse }) => impulse ?? 0));
}

/** Whether the motion of a cart changed as the contact's impulse would change it. @param {Run} run @param {Touch} touch @param {string} cart @param {number} impulse in N s, + to the right */
function isAlone(run, { start, end }, cart, impulse) {
  const change = velocity(run, cart, end) - velocity(run, cart, start);
  return Math.abs(massOf(run, cart) * change - impulse) <= ALONE * Math.abs(impulse);
}
