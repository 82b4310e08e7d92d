/** Error against time on logarithmic axes. Twin of `sim/pages/cost/figure.py`, which drew the axes. */

import { px } from "../../../view/numbers.js";
import { need, put, svg } from "../shared/dom.js";

/**
 * @typedef {{method: string, step?: number | null, rtol?: number, evaluations: number, time_ratio: number,
 *   error_v: number | null, energy_error: number | null}} CostRow
 */

const [LEFT, TOP, RIGHT, BOTTOM] = [62, 14, 506, 330];
const FLOOR = 1e-17; // errors below are drawn here: nought has no logarithm
const [LOW_X, HIGH_X] = [0.5, 1e6];
const HIGH_Y = 10;

/** @param {number} ratio @returns {number} drawing coordinate of a time ratio */
export function xAt(ratio) {
  const part = Math.log(Math.max(ratio, LOW_X) / LOW_X) / Math.log(HIGH_X / LOW_X);
  return LEFT + Math.min(1, part) * (RIGHT - LEFT);
}

/** @param {number} error @returns {number} drawing coordinate of an error */
export function yAt(error) {
  const seen = Math.min(HIGH_Y, Math.max(error, FLOOR));
  return BOTTOM - (Math.log(seen / FLOOR) / Math.log(HIGH_Y / FLOOR)) * (BOTTOM - TOP);
}

/** Where the exact run of a scene is the reference, it has no error of its own. @param {CostRow} row */
export function errorOf(row) {
  return row.error_v ?? (row.method === "exact" ? 0 : null);
}

export class CostFigure {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.ring = need(root, ".carts-cost-ring");
    /** @type {Map<string, {group: Element, mark: string}>} */
    this.groups = new Map();
    const marks = [...root.querySelectorAll(".carts-cost-key .carts-cost-point")];
    for (const [k, group] of [...root.querySelectorAll("[data-method]")].entries()) {
      const mark = marks[k]?.getAttribute("d") ?? "";
      this.groups.set(group.getAttribute("data-method") ?? "", { group, mark });
    }
  }

  /** @param {CostRow[]} rows */
  show(rows) {
    for (const [method, { group, mark }] of this.groups) {
      const places = rows
        .filter((row) => row.method === method && errorOf(row) !== null)
        .map((row) => [px(xAt(row.time_ratio)), px(yAt(Number(errorOf(row))))]);
      const line = places.map(([x, y], k) => `${k ? "L" : "M"}${x} ${y}`).join("");
      group.replaceChildren(
        svg("path", { class: "carts-cost-line", d: line }),
        ...places.map(([x, y]) =>
          svg("path", { class: "carts-cost-point", transform: `translate(${x} ${y})`, d: mark }),
        ),
      );
    }
  }

  /** Rings the row that the reader has chosen, if it has been measured. @param {CostRow | undefined} row */
  mark(row) {
    const error = row ? errorOf(row) : null;
    put(this.ring, "visibility", row && error !== null ? "visible" : "hidden");
    if (!row || error === null) return;
    put(this.ring, "cx", px(xAt(row.time_ratio)));
    put(this.ring, "cy", px(yAt(error)));
  }
}
