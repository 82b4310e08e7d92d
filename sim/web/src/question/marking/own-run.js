/** What a student's own run says about a quantity, in SI. */

import { turnAfter, valueAt } from "../../../../view/trajectory.js";

const NOUGHT = 1e-12; // of the greatest in the run: a cart that stops dead has rounding left

/**
 * @param {any} run `el.trajectory` of the scene @param {Record<string, number>} mass kg, by cart
 * @param {string} quantity v.A, x.A, a.A, p.A or F.A-B @param {number | string} at seconds, start, end or largest
 * @returns {number | null}
 */
export function reading(run, mass, quantity, at) {
  const [what, ...rest] = quantity.split(".");
  const whose = rest.join(".");
  const column = (what === "p" ? run.v : run[String(what)])?.[whose];
  if (!column?.length) return null;
  const factor = what === "p" ? (mass[whose] ?? Number.NaN) : 1;
  const slopes = { x: run.v, v: run.a, p: run.a, F: run.dF }[String(what)]?.[whose] ?? null;
  if (at === "largest") {
    let most = 0;
    const take = (/** @type {number} */ value) => {
      if (Math.abs(value) > Math.abs(most)) most = value;
    };
    column.forEach(take);
    for (let k = 0; k < column.length; k += 1) take(turnAfter(run.t, column, slopes, k) ?? 0);
    return most * factor;
  }
  let scale = 0;
  for (const value of column) scale = Math.max(scale, Math.abs(value));
  const t = at === "end" ? run.t[run.t.length - 1] : at === "start" ? run.t[0] : Number(at);
  const found = valueAt(run.t, column, slopes, t);
  return Math.abs(found) <= NOUGHT * scale ? 0 : found * factor;
}
