/**
 * Forces of effects on single carts: which ones, by whom, how large. Each names two objects.
 * Twin of `sim/pages/widget/effects_forces.py`.
 */

import { heard, tr } from "./language.js";
import { listed } from "./listed.js";
import { decimalsFor, fixed } from "./numbers.js";
import { valueAt } from "./trajectory.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Run} Run */
/** @typedef {import("./types.js").Effect} Effect */
/** @typedef {{kind: string, on: string, by: string, value: number, size: string}} Acting N, + is to the right; `size` without sign as text */

const ON_ONE = ["incline", "push", "friction", "drag"]; // in this order from above to below
export const FEW = 3; // carts; with more, all forces of one kind share a row

/** @type {Record<string, string>} */
const AGENTS = {
  friction: tr("the track"),
  drag: tr("the air"),
  incline: tr("the Earth"),
};

/** @param {Effect} effect @returns {string} who or what its force comes from */
export function agent({ kind, by }) {
  return AGENTS[kind] ?? heard(by ?? "");
}

/** @param {Effect} effect @param {number} t in s @returns {boolean} whether it acts; a push does from its beginning to its end */
export function actsAt({ kind, active, numbers }, t) {
  if (!active) return false;
  const { from = 0, until = Infinity } = numbers;
  return kind !== "push" || (t >= from && t < until);
}

/** Every force of an effect on one cart. */
/** @param {Run} run @param {number} t in s @param {boolean} always with pushes that do not last at t: 0 N @returns {Acting[]} */
export function forcesAt({ header, trajectory }, t, always = false) {
  /** @type {Acting[]} */
  const found = [];
  for (const kind of ON_ONE) {
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
      const value = Math.abs(exact) <= 1e-9 * peak ? 0 : exact;
      const size = value ? fixed(Math.abs(value), decimalsFor(peak || 1)) : "0";
      found.push({ kind, on: name, by: listed([...new Set(own.map(agent))]), value, size });
    }
  }
  return found;
}

/** @param {Acting} force @returns {string[]} what may stand beside its arrow; the shorter where room is scarce */
export function labels({ kind, on, by, size }) {
  const told = { on, by, size };
  const brief = { ...told, by: by.replaceAll("the ", "") };
  return [
    kind === "incline"
      ? tr("on {on} by {by} (slope): {size} N", told)
      : tr("on {on} by {by}: {size} N", told),
    tr("on {on} by {by}: {size} N", brief),
    tr("by {by}: {size} N", brief), // whose force it is tells the line from the cart
  ];
}

/** @param {Header} header @returns {string} what gets the momentum that the carts give away: “wall + Earth”, “air”; “” where nothing */
export function outside({ effects, track }) {
  const walls = track.left === "wall" || track.right === "wall";
  const has = (/** @type {string} */ kind) => effects.some((effect) => effect.kind === kind);
  const parts = [
    walls ? tr("wall") : "",
    has("friction") ? tr("track") : "",
    has("drag") ? tr("air") : "",
    ...effects.filter(({ kind }) => kind === "push").map(agent),
    walls || has("friction") || has("incline") ? tr("Earth") : "",
  ];
  return [...new Set(parts.filter(Boolean))].join(" + ");
}

/** @param {Header} header @param {string} pair @returns {string} “spring” or “magnets” where one acts between the two, else “” */
export function linkKind({ effects }, pair) {
  const link = effects.find(
    ({ kind, active, between }) =>
      active && (kind === "spring" || kind === "magnets") && between?.join("-") === pair,
  );
  return link?.kind ?? "";
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
