/** One instant of a run in a sentence: for those who do not see the picture. */

import { forcesAlong } from "./forces.js";
import { tr } from "./language.js";
import { fixed, NOISE } from "./numbers.js";
import { valueAt } from "./trajectory.js";
import { capital, motion } from "./words.js";

/** @typedef {import("./types.js").Run} Run */
/** @typedef {import("./types.js").View} View */

const FEW = 6; // carts; of more nobody could listen to all

/**
 * Where the carts are, how they move, and every force along the track.
 * @param {Run} run @param {number} t in s @param {View} view @param {number} camera in m/s @param {boolean} forces whether they are told
 */
export function instant(run, t, view, camera, forces) {
  const { header, trajectory } = run;
  const { decimals } = view;
  const time = tr("At {time} s:", { time: fixed(t, decimals.t ?? 3) });
  const names = header.bodies.slice(0, FEW).map(({ name }) => name);
  const carts = names.map((name) => {
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
  return [time, ...carts, ...(forces ? pushes(run, t, view, names) : [])].join(" ");
}

/** Every force along the track that acts at t on these carts or on a wall, as it is drawn. @param {Run} run @param {number} t in s @param {View} view @param {string[]} carts */
function pushes(run, t, view, carts) {
  const zero = NOISE * (view.force || 1);
  return ["left", ...carts, "right"].flatMap((name) =>
    forcesAlong(run, name, t, zero).flatMap(({ name: force, value, size: written }) => {
      const size = written ?? fixed(Math.abs(value), view.decimals.F ?? 2);
      if (!value || !Number(size)) return [];
      const told = { force: capital(force), size: `${size}\u00a0N` };
      return value < 0
        ? tr("{force}: {size} to the left.", told)
        : tr("{force}: {size} to the right.", told);
    }),
  );
}
