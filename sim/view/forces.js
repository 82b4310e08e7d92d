/**
 * Every force on a body at an instant. Each names two objects: the body it acts on and the one it
 * comes from. Contact forces come out of the run; weight and support of what the track holds up.
 */

import { body, forceOn } from "./bodies.js";
import { linkOf, viewOf } from "./effects.js";
import { forcesAt } from "./effects-forces.js";
import { tr } from "./language.js";
import { valueAt } from "./trajectory.js";

/** @typedef {import("./types.js").Run} Run */
/**
 * `value` in N, + to the right, or up where `way` is "up"; `side`: where on the body it acts.
 * @typedef {{name: string, on: string, by: string, way: "along" | "up", side: "left" | "right" | "middle" | "below" | "above", value: number, size?: string}} Force
 */

/** @param {Run} run @param {string} pair @param {number} t in s @param {number} zero smaller counts as none @returns {number} N, pushes the two apart; below 0 a spring pulls them together */
export function contactForce({ trajectory }, pair, t, zero) {
  const column = trajectory.F[pair];
  if (!column) return 0; // the two never meet in this run
  const force = valueAt(trajectory.t, column, trajectory.dF[pair] ?? null, t);
  return Math.abs(force) < zero ? 0 : force;
}

/**
 * The sum of all forces on a cart along the track, as they are drawn and told: m a, in N.
 * @param {Run} run @param {string} name @param {number} t in s @param {number} zero in N @returns {number}
 */
export function resultant(run, name, t, zero) {
  return summed(forcesAlong(run, name, t, zero));
}

/** N, + to the right. @param {Force[]} along */
export const summed = (along) => along.reduce((sum, { value }) => sum + value, 0);

/** All forces on a cart along the track. @param {Run} run @param {string} name @param {number} t in s @param {number} zero in N @returns {Force[]} */
export function forcesAlong(run, name, t, zero) {
  return [...contactForces(run, name, t, zero), ...effectForces(run, name, t)];
}

/**
 * The contact forces on a cart or a wall, from the left neighbour first. What holds two together that stick
 * is told while it is there: their contact has no duration, and no force of its own.
 * @param {Run} run @param {string} name @param {number} t in s @param {number} zero in N @returns {Force[]}
 */
export function contactForces(run, name, t, zero) {
  return run.header.contacts
    .filter(({ bodies }) => bodies.includes(name))
    .map((contact) => ({ ...contact, size: contactForce(run, contact.pair, t, zero) }))
    .filter(({ pair, stiffness, size }) => size || stiffness || linkOf(run.header, pair))
    .map(({ bodies: [left, right], size }) => {
      const isLeft = left === name;
      const by = isLeft ? right : left;
      return {
        name: forceOn(body(name, run.header.track), body(by, run.header.track)),
        on: name,
        by,
        way: /** @type {const} */ ("along"),
        side: isLeft ? /** @type {const} */ ("right") : /** @type {const} */ ("left"),
        value: isLeft ? -size : size,
      };
    })
    .sort((a, b) => (a.side < b.side ? -1 : 1));
}

/** Forces of effects on a cart: by the track at its foot, by the air at its top, by a hand at its face. */
/** @param {Run} run @param {string} name @param {number} t in s @returns {Force[]} */
export function effectForces(run, name, t) {
  return forcesAt(run, t, true)
    .filter(({ on }) => on === name)
    .map(({ kind, on, by, value, size }) => {
      const { forceName = forceOn, side } = viewOf(kind);
      const at = side?.(value) ?? "middle";
      return { name: forceName(on, by), on, by, way: "along", side: at, value, size };
    });
}

/** What is said below weight and support: on a slope they balance in part only. @param {import("./types.js").Header} header */
export function verticalNote(header) {
  return header.bodies.some(({ name }) => slopeOf(header, name))
    ? tr(
        "On a slope the support balances only the part of the weight across the track; the rest of the weight acts along it. Weight and support are no third-law pair: the partner of the weight pulls on the Earth.",
      )
    : tr(
        "Weight and support are equal and opposite here, but both act on one cart: they balance. They are no third-law pair: the partner of the weight pulls on the Earth.",
      );
}

/** @param {import("./types.js").Header} header @param {string} name @returns {number} of the track below a cart, in rad */
function slopeOf({ effects }, name) {
  return effects
    .filter(({ active, carts }) => active && carts.includes(name))
    .reduce((sum, effect) => sum + (viewOf(effect.kind).slope?.(effect) ?? 0), 0);
}

/**
 * Weight, on a slope the part across it, and support: equal and opposite, but both on one body, so
 * no third-law pair.
 * @param {Run} run @param {string} name @returns {Force[]}
 */
export function verticalForces({ header }, name) {
  const mass = header.bodies.find((one) => one.name === name)?.mass ?? 0;
  const slope = slopeOf(header, name);
  const weight = mass * header.gravity * Math.cos(slope);
  return [
    {
      name: slope
        ? tr("part of the weight of {name}, across the track: force on {name} by the Earth", {
            name,
          })
        : tr("weight of {name}: force on {name} by the Earth", { name }),
      by: "Earth",
      value: -weight,
    },
    {
      name: tr("support: force on {name} by the track", { name }),
      by: "track",
      value: weight,
    },
  ].map((force) => ({ ...force, on: name, way: "up", side: "middle" }));
}
