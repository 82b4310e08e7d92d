/** Whether a run fulfils a goal: a comparison that `sim/lesson/goal.py` read. */

import { reading } from "./own-run.js";

/** @typedef {{factor: number, quantity: string, at: "start" | "end" | "largest"}} Term */
/** @typedef {{left: Term, relation: "=" | "<" | ">", right: Term}} Goal */

/**
 * @param {Goal} goal @param {any} run `el.trajectory` of the scene @param {Record<string, number>} mass kg, by cart
 * @param {number} near of the larger side; beside zero, of the largest such quantity in the run
 */
export function isMet({ left, relation, right }, run, mass, near) {
  const [a, b] = [value(left, run, mass), value(right, run, mass)];
  if (a === null || b === null) return false;
  if (relation === "<") return a < b;
  if (relation === ">") return a > b;
  const scale = Math.max(Math.abs(a), Math.abs(b));
  const beside = a === 0 || b === 0 ? largest(left.quantity || right.quantity, run, mass) : scale;
  return Math.abs(a - b) <= near * beside;
}

/** In SI. @param {Term} term @param {any} run @param {Record<string, number>} mass @returns {number | null} */
function value({ factor, quantity, at }, run, mass) {
  if (!quantity) return factor;
  const [what, whose = ""] = quantity.split(/\.(.*)/s);
  if (what !== "F" || whose in run.F) {
    const read = reading(run, mass, quantity, at);
    return read === null ? null : factor * read;
  }
  const forces = touching(run, whose).map((pair) => reading(run, mass, `F.${pair}`, at) ?? 0);
  return factor * forces.reduce((most, force) => Math.max(most, Math.abs(force)), 0);
}

/** The pairs of which a body is one. @param {any} run @param {string} name @returns {string[]} */
function touching(run, name) {
  const [left, right] = [`${name}-`, `-${name}`]; // a name may have a hyphen of its own
  const others = new Set([...Object.keys(run.x), "left", "right"]);
  return Object.keys(run.F).filter(
    (pair) =>
      (pair.startsWith(left) && others.has(pair.slice(left.length))) ||
      (pair.endsWith(right) && others.has(pair.slice(0, -right.length))),
  );
}

/** The largest size of a kind of quantity, over all bodies and times. @param {string} quantity @param {any} run @param {Record<string, number>} mass */
function largest(quantity, run, mass) {
  const what = quantity.charAt(0);
  const names = Object.keys((what === "p" ? run.v : run[what]) ?? {});
  const all = names.map((name) => reading(run, mass, `${what}.${name}`, "largest") ?? 0);
  return Math.max(0, ...all.map(Math.abs));
}
