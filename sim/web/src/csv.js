/** A run as a table for a spreadsheet: every row of the run, in full precision. */

import { seriesOf } from "./series.js";
import { isTold } from "./trajectory.js";
import { QUANTITIES } from "./words.js";

/** @typedef {import("./types.js").Run} Run */

/**
 * Text of a CSV file. Time starts at 0; each header names the quantity and its unit. Two rows with
 * one time are a jump: before and after.
 * @param {Run} run @param {string[]} quantities @param {number} camera in m/s @returns {string}
 */
export function csv(run, quantities, camera) {
  if (!isTold(run)) return "";
  const { header, trajectory } = run;
  /** @type {[string, ArrayLike<number>][]} */
  const columns = [["t in s", trajectory.t]];
  for (const quantity of quantities) {
    const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", quantity, ""];
    for (const { label, values } of seriesOf(quantity, header, trajectory, camera, true)) {
      const name = quantity === "F" ? `F ${label}` : `${symbol} of ${label}`;
      columns.push([`${title.toLowerCase()} ${name} in ${unit}`, values]);
    }
  }
  const lines = [columns.map(([name]) => quoted(name)).join(",")];
  for (let k = 0; k < trajectory.t.length; k += 1) {
    lines.push(columns.map(([, values]) => String(Number(values[k]) || 0)).join(","));
  }
  return `${lines.join("\r\n")}\r\n`;
}

/** @param {string} text */
function quoted(text) {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
