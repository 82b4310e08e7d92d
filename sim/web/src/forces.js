/**
 * Every force on a body at an instant. Each names two objects: the body it acts on and the one it
 * comes from. Contact forces come out of the run; weight and support of what the track holds up.
 */

import { styleOf } from "./markers.js";
import { valueAt } from "./trajectory.js";
import { body } from "./words.js";

/** @typedef {import("./types.js").Run} Run */
/**
 * `value` in N, + to the right, or up where `way` is "up"; `side`: where on the body it acts.
 * @typedef {{name: string, on: string, by: string, way: "along" | "up", side: "left" | "right" | "middle", value: number}} Force
 */

/** @param {Run} run @param {string} pair @param {number} t in s @param {number} zero smaller counts as none @returns {number} N, 0 or more */
export function contactForce({ trajectory }, pair, t, zero) {
  const force = valueAt(trajectory.t, trajectory.F[pair] ?? [0], trajectory.dF[pair] ?? [0], t);
  return force < zero ? 0 : force;
}

/** The contact forces on a cart, from the left neighbour first. */
/** @param {Run} run @param {string} name @param {number} t in s @param {number} zero in N @returns {Force[]} */
export function contactForces(run, name, t, zero) {
  return run.header.contacts
    .filter(({ bodies, stiffness }) => stiffness && bodies.includes(name))
    .map(({ pair, bodies: [left, right] }) => {
      const size = contactForce(run, pair, t, zero);
      const isLeft = left === name;
      const by = isLeft ? right : left;
      return {
        name: `force on ${name} by ${body(by)}`,
        on: name,
        by,
        way: /** @type {const} */ ("along"),
        side: isLeft ? /** @type {const} */ ("right") : /** @type {const} */ ("left"),
        value: isLeft ? -size : size,
      };
    })
    .sort((a, b) => (a.side < b.side ? -1 : 1));
}

/**
 * Weight and support: equal and opposite, but both on one body, so no third-law pair.
 * @param {Run} run @param {string} name @returns {Force[]}
 */
export function verticalForces({ header }, name) {
  const mass = header.bodies.find((one) => one.name === name)?.mass ?? 0;
  const weight = mass * header.gravity;
  return [
    { name: `weight of ${name}: force on ${name} by the Earth`, by: "Earth", value: -weight },
    { name: `support: force on ${name} by the track`, by: "track", value: weight },
  ].map((force) => ({ ...force, on: name, way: "up", side: "middle" }));
}

/** @param {Run} run @param {string} name @returns {string} the style of the body a force comes from */
export function styleOfBody({ header }, name) {
  const index = header.bodies.findIndex((one) => one.name === name);
  return index < 0 ? "wall" : styleOf(index);
}
