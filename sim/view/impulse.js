/** The impulse of a touch: the area under the force curve from the first touch to the cursor. */

import { isLink } from "./effects.js";
import { hermite, rowAt, valueAt } from "./trajectory.js";

/** @typedef {import("./types.js").Run} Run */
/** @typedef {import("./windows.js").Touch} Touch */

/**
 * Area in N s under the force of a pair, exact for the curve as it is drawn: Simpson's rule has no
 * error on a cubic, and a jump lies between two rows of one time.
 * @param {Run} run @param {string} pair @param {number} from in s @param {number} to in s @returns {number}
 */
export function area({ trajectory }, pair, from, to) {
  const { t, F, dF } = trajectory;
  const [values, slopes] = [F[pair] ?? [], dF[pair] ?? []];
  let sum = 0;
  for (let k = Math.max(0, rowAt(t, from)); k < t.length - 1 && Number(t[k]) < to; k += 1) {
    const [low, high] = [Math.max(from, Number(t[k])), Math.min(to, Number(t[k + 1]))];
    if (high <= low) continue;
    const at = (/** @type {number} */ when) => hermite(t, values, slopes, k, when);
    sum += ((high - low) / 6) * (at(low) + 4 * at((low + high) / 2) + at(high));
  }
  return sum;
}

/**
 * m Δv of both bodies of a touch since it began, where nothing else pushes them; null for a wall or
 * a cart that others push too.
 * @param {Run} run @param {Touch[]} windows @param {Touch} touch @param {number} t in s @returns {{name: string, change: number | null}[]}
 */
export function changes({ header, trajectory }, windows, touch, t) {
  /** Whether a contact without duration changed the motion meanwhile, or holds the two together. @param {string} pair */
  const felt = (pair) =>
    header.events.some(
      (event) =>
        event.bodies?.join("-") === pair &&
        event.t <= t &&
        (event.t >= touch.start || trajectory.F[pair]),
    );
  return touch.bodies.map((name) => {
    const mass = header.bodies.find((body) => body.name === name)?.mass;
    const others = windows.some(
      (one) => one !== touch && one.bodies.includes(name) && one.start < t && one.end > touch.start,
    );
    const acting = header.effects.some(
      (effect) =>
        effect.active &&
        effect.carts.includes(name) &&
        !(isLink(effect) && effect.between?.join("-") === touch.pair), // what a pair's own spring does is in its F
    );
    const brief = header.contacts.some(
      ({ pair, bodies, stiffness }) =>
        pair !== touch.pair && !stiffness && bodies.includes(name) && felt(pair),
    );
    if (mass === undefined || others || acting || brief) return { name, change: null };
    const v = (/** @type {number} */ at) =>
      valueAt(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], at);
    return { name, change: mass * (v(t) - v(touch.start)) };
  });
}
