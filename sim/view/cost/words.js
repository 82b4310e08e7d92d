/** Numbers beside the two runs, and the table of all measurements. */

import { tr } from "../language.js";
import { fixed, short } from "../numbers.js";
import { METHODS } from "./methods.js";

/** @typedef {import("./figure.js").CostRow} CostRow */
/**
 * @typedef {{until: number, rows: number, steps: number, evaluations: number,
 *   bodies: {name: string, mass: number, length: number}[],
 *   track: {left: string, right: string, length: number | null},
 *   v: {stepped: Record<string, number | null>, exact: Record<string, number>},
 *   energy: {initial: number, stepped: number | null, exact: number, imbalance: number | null}}} CostHeader
 */

const [MANY, HUGE] = [1000, 10_000];
const FEW = 10; // times the energy of the start, where a push or magnets bring in more
/** What is shown first. */
export const FIRST = { method: "euler", parts: 103 };
const ENDLESS = tr("beyond all numbers");

/** @param {number} part @param {number} whole */
function percent(part, whole) {
  return `${plain((100 * part) / whole, 1)} %`;
}

/** Whether energies are told in parts of that at the start; else in joules. @param {number} start @param {number} most */
export const inParts = (start, most) => start > 0 && most < FEW * start;

/** So that two that differ look different. @param {number} value */
function joules(value) {
  return `${Math.abs(value) < 0.1 ? short(value) : plain(value, 3)} J`;
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
      tr("velocity of {name} at the end", { name }),
      got,
      `${plain(Number(v.exact[name]), 4)} m/s`,
    ]);
  });
  const { initial, stepped, exact, imbalance } = energy;
  const part = inParts(initial, exact);
  /** @param {number} value */
  const amount = (value) => (part ? percent(value, initial) : joules(value));
  return [
    ...speeds,
    [
      part ? tr("energy at the end, of that at the start") : tr("energy at the end"),
      stepped === null ? ENDLESS : amount(stepped),
      amount(exact),
    ],
    [tr("energy made from nothing"), imbalance === null ? ENDLESS : `${short(imbalance)} J`, "0 J"],
    [tr("times that all forces were computed"), String(evaluations), "0"],
  ];
}

/** @param {number} rtol @returns {string} a power of ten as it is typed at a command line */
export function toleranceText(rtol) {
  return tr("tolerance {size}", { size: `1e${Math.round(Math.log10(rtol))}` });
}

/** @param {CostRow} row @param {number} until @returns {string[]} a line of the table, its head first */
export function cells(row, until) {
  let size = "–";
  if (row.rtol) size = toleranceText(row.rtol);
  else if (row.step) size = `${short(until)} s / ${Math.round(until / row.step)}`;
  const ratio = row.time_ratio;
  return [
    METHODS[row.method]?.label ?? row.method,
    size,
    String(row.evaluations),
    ratio >= MANY ? String(Math.round(ratio)) : short(ratio),
    errorText(row, row.error_v),
    errorText(row, row.energy_error),
  ];
}

/** Of a run that stepped, only numbers beyond all bounds are missing. @param {CostRow} row @param {number | null} error */
function errorText({ evaluations }, error) {
  if (error !== null) return short(error, 2);
  return evaluations ? ENDLESS : "–";
}

/**
 * The measurement of a method with a step, or with a tolerance where it has one.
 * @param {CostRow[]} rows @param {number} until in s @param {{method: string, rtol: number, parts: number}} chosen
 */
export function rowOf(rows, until, { method, rtol, parts }) {
  return rows.find((row) => {
    if (row.method !== method) return false;
    return row.rtol ? row.rtol === rtol : Math.round(until / Number(row.step)) === parts;
  });
}
