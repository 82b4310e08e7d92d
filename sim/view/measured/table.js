/** The table of readings: a row for each time, with the residuals where a model lies over them. */

import { tr } from "../language.js";
import { fixed } from "../numbers.js";
import { heads } from "./units.js";

/** @typedef {import("./types.js").Read} Read */

const PLACES = 4; // decimals of readings in SI units

/** @param {Read} read @param {number[][] | null} residuals in m @returns {{head: string[], rows: string[][]}} */
export function tableOf(read, residuals) {
  const { names, tracks } = read;
  const { time, tracks: its } = heads(read);
  const head = [time, ...its];
  if (residuals) head.push(...names.map((cart) => tr("residual of {cart} in mm", { cart })));
  /** @type {Map<number, string[]>} */
  const found = new Map();
  for (const [k, track] of tracks.entries()) {
    for (const [n, t] of track.t.entries()) {
      const cells = found.get(t) ?? Array.from({ length: head.length - 1 }, () => "");
      cells[k] = fixed(Number(track.value[n]), PLACES);
      if (residuals) cells[2 + k] = fixed(1000 * Number(residuals[k]?.[n]), 2);
      found.set(t, cells);
    }
  }
  const rows = [...found]
    .sort(([a], [b]) => a - b)
    .map(([t, cells]) => [fixed(t, PLACES), ...cells]);
  return { head, rows };
}
