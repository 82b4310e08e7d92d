/** Numbers beside the two runs, and the table of all measurements. Twin of `told` and `cells` in `pages/cost/render.py`. */

import { fixed, short } from "../../../view/numbers.js";
import { html } from "../shared/dom.js";

/** @typedef {import("./figure.js").CostRow} CostRow */
/**
 * @typedef {{until: number, rows: number, steps: number, evaluations: number,
 *   bodies: {name: string, mass: number, length: number}[],
 *   track: {left: string, right: string, length: number | null},
 *   v: {stepped: Record<string, number | null>, exact: Record<string, number>},
 *   energy: {initial: number, stepped: number | null, exact: number, imbalance: number | null}}} CostHeader
 */

const [MANY, HUGE] = [1000, 10_000];
const ENDLESS = "beyond all numbers";

/** @param {number} part @param {number} whole */
function percent(part, whole) {
  return `${plain(whole ? (100 * part) / whole : 100, 1)} %`;
}

/** Numbers that no cart could have as powers of ten. @param {number} value @param {number} decimals */
function plain(value, decimals) {
  return Math.abs(value) < HUGE ? fixed(value, decimals) : short(value);
}

/** @param {CostHeader} header @returns {[string, string, string][]} quantity, as stepped, exactly */
export function told({ v, energy, evaluations }) {
  const speeds = Object.entries(v.stepped).map(([name, speed]) => {
    const got = speed === null ? ENDLESS : `${plain(speed, 4)} m/s`;
    return /** @type {[string, string, string]} */ ([
      `velocity of ${name} at the end`,
      got,
      `${plain(Number(v.exact[name]), 4)} m/s`,
    ]);
  });
  const { initial, stepped, exact, imbalance } = energy;
  return [
    ...speeds,
    [
      "energy at the end, of that at the start",
      stepped === null ? ENDLESS : percent(stepped, initial),
      percent(exact, initial),
    ],
    ["energy made from nothing", imbalance === null ? ENDLESS : `${short(imbalance)} J`, "0 J"],
    ["times that all forces were computed", String(evaluations), "0"],
  ];
}

/** @param {CostRow} row @param {number} until @param {Record<string, string>} labels @returns {string[]} */
export function cells(row, until, labels) {
  let size = "–";
  if (row.rtol) size = `tolerance 1e${Math.round(Math.log10(row.rtol))}`;
  else if (row.step) size = `${short(until)} s / ${Math.round(until / row.step)}`;
  const ratio = row.time_ratio;
  return [
    labels[row.method] ?? row.method,
    size,
    String(row.evaluations),
    ratio >= MANY ? String(Math.round(ratio)) : short(ratio),
    row.error_v === null ? "–" : short(row.error_v, 2),
    row.energy_error === null ? "–" : short(row.energy_error, 2),
  ];
}

/** @param {Element} table @param {string[][]} lines the first of each is its head */
export function fill(table, lines) {
  const body = lines.map(([head = "", ...values]) => {
    const line = html("tr");
    const first = html("th", "", head);
    first.setAttribute("scope", "row");
    line.append(first, ...values.map((value) => html("td", "", value)));
    return line;
  });
  table.querySelector("tbody")?.replaceChildren(...body);
}
