/** One instant of a run in a sentence: for those who do not see the picture. */

import { body, forceOn, isWall } from "./bodies.js";
import { tr } from "./language.js";
import { fixed, NOISE } from "./numbers.js";
import { valueAt } from "./trajectory.js";
import { motion } from "./words.js";

/** @typedef {import("./types.js").Run} Run */
/** @typedef {import("./types.js").View} View */

const FEW = 6; // carts; of more nobody could listen to all

/**
 * Where the carts are, how they move, and how hard they push each other.
 * @param {Run} run @param {number} t in s @param {View} view @param {number} camera in m/s @param {boolean} forces whether they are told
 */
export function instant({ header, trajectory }, t, view, camera, forces) {
  const { decimals } = view;
  const time = tr("At {time} s:", { time: fixed(t, decimals.t ?? 3) });
  const carts = header.bodies.slice(0, FEW).map(({ name }) => {
    const [x, v, a] = [trajectory.x[name], trajectory.v[name], trajectory.a[name]];
    const place = valueAt(trajectory.t, x ?? [], v ?? [], t) - camera * t;
    const speed = valueAt(trajectory.t, v ?? [], a ?? [], t) - camera;
    const seen = Math.abs(speed) < NOISE * view.velocity ? 0 : speed;
    return tr("{cart} at {place} m, {velocity}.", {
      cart: name,
      place: fixed(place, decimals.x ?? 3),
      velocity: motion(seen, decimals.v ?? 2, view.velocity),
    });
  });
  return [time, ...carts, ...(forces ? pushes(header, trajectory, t, decimals.F ?? 2) : [])].join(
    " ",
  );
}

/** @param {import("./types.js").Header} header @param {import("./types.js").Trajectory} trajectory @param {number} t @param {number} decimals */
function pushes({ contacts, track }, { t: times, F, dF }, t, decimals) {
  return contacts.flatMap(({ pair, bodies: [left, right] }) => {
    const force = F[pair] ? valueAt(times, F[pair], dF[pair] ?? null, t) : 0;
    const size = fixed(Math.abs(force), decimals);
    if (!Number(size)) return [];
    const [one, other] = isWall(left) ? [right, left] : [left, right];
    const names = {
      one: forceOn(body(one, track), body(other, track)),
      other: forceOn(body(other, track), body(one, track)),
      size,
    };
    return [tr("{one}: {size} N; {other}: {size} N.", names)];
  });
}
