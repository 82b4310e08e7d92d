/** Forces of effects on single carts: which ones, by whom, how large. Each names two objects. */

import { kind as kindOf, listed } from "./bodies.js";
import { actsAt, agent, kindsOnOne, viewOf } from "./effects.js";
import { tr } from "./language.js";
import { decimalsFor, fixed, NOISE } from "./numbers.js";
import { valueAt } from "./trajectory.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Run} Run */
/** @typedef {{kind: string, on: string, by: string, value: number, size: string}} Acting N, + is to the right; `size` without sign as text */

export const FEW = 3; // carts; with more, all forces of one kind share a row

/** Every force of an effect on one cart. */
/** @param {Run} run @param {number} t in s @param {boolean} always with forces that do not act at t: 0 N @returns {Acting[]} */
export function forcesAt({ header, trajectory }, t, always = false) {
  /** @type {Acting[]} */
  const found = [];
  for (const kind of kindsOnOne(header)) {
    const acting = header.effects.filter(
      (effect) => effect.kind === kind && (always ? effect.active : actsAt(effect, t)),
    );
    for (const { name } of header.bodies) {
      const own = acting.filter((effect) => effect.carts.includes(name));
      const column = trajectory.E[`${kind} ${name}`];
      if (!own.length || !column?.length) continue;
      const peak = greatest(column);
      const on = own.some((effect) => actsAt(effect, t));
      const exact = on ? valueAt(trajectory.t, column, null, t) : 0;
      const value = Math.abs(exact) <= NOISE * peak ? 0 : exact;
      const size = value ? fixed(Math.abs(value), decimalsFor(peak || 1)) : "0";
      found.push({ kind, on: name, by: listed([...new Set(own.map(agent))]), value, size });
    }
  }
  return found;
}

/** The force of each effect on one cart, over the whole run. @param {Header} header @param {import("./types.js").Trajectory} run @param {string} name */
export function partsOf(header, run, name) {
  return kindsOnOne(header).flatMap((kind) => {
    const own = header.effects.filter(
      (effect) => effect.kind === kind && effect.active && effect.carts.includes(name),
    );
    const column = run.E[`${kind} ${name}`];
    return own.length && column?.length
      ? [{ by: listed([...new Set(own.map(agent))]), column }]
      : [];
  });
}

/** @param {Acting} force @returns {string[]} what may stand beside its arrow; the shorter where room is scarce */
export function labels({ kind, on, by, size }) {
  const told = { on, by, size };
  const brief = { ...told, by: by.replaceAll("the ", "") };
  return [
    viewOf(kind).label?.(told) ?? tr("on {on} by {by}: {size} N", told),
    tr("on {on} by {by}: {size} N", brief),
    tr("by {by}: {size} N", brief), // whose force it is tells the line from the cart
  ];
}

/** @param {Header} header @returns {string} what gets the momentum that the carts give away: “wall + Earth”, “air”; “” where nothing */
export function outside(header) {
  const { effects, track } = header;
  const sides = /** @type {const} */ (["left", "right"]);
  const walls = sides.filter((side) => track[side] === "wall").map((side) => kindOf(side, track));
  const kinds = kindsOnOne(header).map(viewOf);
  const media = kinds.map(({ around }) => (typeof around === "string" ? around : ""));
  const others = effects.map((effect) => {
    const { around } = viewOf(effect.kind);
    return typeof around === "function" ? around(effect, agent(effect)) : "";
  });
  const earth = walls.length || kinds.some((view) => view.earth) ? tr("Earth") : "";
  const parts = [...walls, ...media, ...others, earth];
  return [...new Set(parts.filter(Boolean))].join(" + ");
}

/** @type {WeakMap<object, number>} */
const known = new WeakMap();

/** The greatest size in a column, looked up once per run. @param {import("./types.js").Column} column */
function greatest(column) {
  const before = known.get(column);
  if (before !== undefined) return before;
  let most = 0;
  for (let k = 0; k < column.length; k += 1) most = Math.max(most, Math.abs(Number(column[k])));
  known.set(column, most);
  return most;
}
