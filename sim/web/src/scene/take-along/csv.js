/** A run as a table for a spreadsheet: every row of the run, in full precision. */

import { forceOn, listed } from "../../../../view/bodies.js";
import { agent, viewOf } from "../../../../view/effects.js";
import { tr } from "../../../../view/language.js";
import { seriesOf } from "../../../../view/series.js";
import { isTold } from "../../../../view/trajectory.js";
import { QUANTITIES } from "../../../../view/words.js";

/** @typedef {import("../../../../view/types.js").Run} Run */

/**
 * Text of a CSV file. Time starts at 0; each header names the quantity and its unit. Two rows with
 * one time are a jump: before and after.
 * @param {Run} run @param {string[]} quantities @param {number} camera in m/s
 * @param {number} seen s, as far as it was watched: no row is of later @returns {string}
 */
export function csv(run, quantities, camera, seen = Infinity) {
  if (!isTold(run)) return "";
  const { header, trajectory } = run;
  /** @type {[string, ArrayLike<number>][]} */
  const columns = [[tr("t in s"), trajectory.t]];
  for (const quantity of quantities) {
    const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", quantity, ""];
    for (const { label, over, values } of seriesOf(quantity, header, trajectory, camera, true)) {
      columns.push([named(quantity, { title, symbol, label, over }) + inUnit(unit), values]);
    }
  }
  if (quantities.includes("F")) columns.push(...effectColumns(run));
  const lines = [columns.map(([name]) => quoted(name)).join(",")];
  for (let k = 0; k < trajectory.t.length && Number(trajectory.t[k]) <= seen; k += 1) {
    lines.push(columns.map(([, values]) => String(Number(values[k]) || 0)).join(","));
  }
  return `${lines.join("\r\n")}\r\n`;
}

/** Forces of effects on single carts: friction, slope, drag, pushes. @param {Run} run @returns {[string, ArrayLike<number>][]} */
function effectColumns({ header, trajectory }) {
  return Object.entries(trajectory.E).map(([key, values]) => {
    const [kind, on] = [key.slice(0, key.indexOf(" ")), key.slice(key.indexOf(" ") + 1)];
    const own = header.effects.filter(
      (effect) => effect.kind === kind && effect.active && effect.carts.includes(on),
    );
    const by = listed([...new Set(own.map(agent))]);
    return [`${forceOn(on, by)} (${viewOf(kind).name})${inUnit("N")}`, values];
  });
}

/** @param {string} quantity @param {{title: string, symbol: string, label: string, over: boolean}} of a series */
function named(quantity, { title, symbol, label, over }) {
  const whole = title.toLowerCase();
  if (quantity === "F") return `${whole} F ${label}`;
  if (quantity === "R" && over) return `F ${label}`; // one of those that the resultant is the sum of
  return tr("{quantity} of {cart}", { quantity: `${whole} ${symbol}`, cart: label });
}

/** @param {string} unit */
const inUnit = (unit) => tr(" in {unit}", { unit });

/** @param {string} text */
function quoted(text) {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
