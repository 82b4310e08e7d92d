/**
 * Error against time on logarithmic axes, one line per method; the exact outcome in the corner. Lower and
 * further left is better. Below the lowest decade stands 0, where rounding has no place.
 */

import { tr } from "../language.js";
import { html } from "../markup.js";
import { px, short, superscript } from "../numbers.js";
import { METHODS } from "./methods.js";

/**
 * @typedef {{method: string, step?: number | null, rtol?: number, evaluations: number, time_ratio: number,
 *   error_v: number | null, energy_error: number | null}} CostRow
 * @typedef {{line: string, points: [string, string][]}} Line drawing coordinates
 */

export const [WIDTH, HEIGHT] = [520, 380];
export const [LEFT, TOP, RIGHT, BOTTOM] = [62, 14, 506, 330];
const FLOOR = 1e-17; // errors below are drawn here: nought has no logarithm
const [LOW_X, HIGH_X] = [0.5, 1e6];
const HIGH_Y = 10;
const TIMES = [0, 1, 2, 3, 4, 5, 6]; // powers of ten
const ERRORS = [-17, -15, -13, -11, -9, -7, -5, -3, -1, 1];
const LEGEND = 18; // units of a line of the legend

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

/** An error of nought stands where doubles end: it has no logarithm. One below it stands where it is. @param {CostRow[]} rows @param {string} method @param {number} [floor] m/s @returns {Line} */
export function lineOf(rows, method, floor = 0) {
  /** @type {[string, string][]} */
  const points = rows
    .filter((row) => row.method === method && errorOf(row) !== null)
    .map((row) => [px(xAt(row.time_ratio)), px(yAt(errorOf(row) || floor))]);
  return { line: points.map(([x, y], k) => `${k ? "L" : "M"}${x} ${y}`).join(""), points };
}

/** @param {number | undefined} floor m/s, half a step of a double; none: nothing is drawn @returns {string} a level line */
export function levelAt(floor) {
  return floor ? `M${LEFT} ${px(yAt(floor))}H${RIGHT}` : "";
}

/** @param {number | undefined} factor @returns {string} of the time, for ten times less error */
export function digitText(factor) {
  return factor ? tr("one more digit: × {factor}", { factor: short(factor, 2) }) : "";
}

/** @returns {{x: [string, string][], y: [string, string][]}} places of the grid with their numbers */
export function grid() {
  return {
    x: TIMES.map((k) => [px(xAt(10 ** k)), power(k)]),
    y: ERRORS.map((k) => [px(yAt(10 ** k)), 10 ** k > FLOOR ? power(k) : "0"]),
  };
}

/** @param {number} exponent @returns {string} 10⁻³; 1 and 10 as they are */
function power(exponent) {
  if (exponent === 0 || exponent === 1) return exponent ? "10" : "1";
  return `10${superscript(exponent)}`;
}

/** The figure as an SVG file, with its legend. @param {{title: string, rows: CostRow[], floor?: number, digits?: Record<string, number>}} values @returns {import("../markup.js").Markup} */
export function standalone({ title, rows, floor, digits = {} }) {
  const lines = Object.entries(METHODS)
    .map(([name, method]) => ({ ...method, ...lineOf(rows, name, floor), digit: digits[name] }))
    .filter(({ points }) => points.length);
  const height = HEIGHT + LEGEND * Math.ceil(lines.length / 2) + 8;
  const { x, y } = grid();
  const series = lines.map(({ line, points, mark, colour, label, digit }, k) => {
    const legend = [px(LEFT + 240 * (k % 2)), px(HEIGHT + 8 + LEGEND * Math.floor(k / 2))];
    const marks = [...points, legend].map(
      ([across, down]) =>
        html`<path transform="translate(${across} ${down})" d=${mark} fill=${colour}/>`,
    );
    return html`<path d=${line} fill="none" stroke=${colour}/>${marks}<text x=${legend[0]} y=${legend[1]} dx="12" dy="4">${label}${digit && ` (a digit: × ${short(digit, 2)})`}</text>`;
  });
  return html`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${px(height)}" width=${WIDTH} height=${px(height)} font-family="sans-serif" font-size="12"><title>${title}: error against time</title><rect width="100%" height="100%" fill="#fff"/><rect x=${LEFT} y=${TOP} width=${RIGHT - LEFT} height=${BOTTOM - TOP} fill="none" stroke="#55585e"/>${x.map(
    ([at, text]) =>
      html`<path d="M${at} ${TOP}V${BOTTOM}" stroke="#e4e6e9"/><text x=${at} y=${BOTTOM + 16} text-anchor="middle">${text}</text>`,
  )}${y.map(
    ([at, text]) =>
      html`<path d="M${LEFT} ${at}H${RIGHT}" stroke="#e4e6e9"/><text x=${LEFT - 7} y=${at} dy="4" text-anchor="end">${text}</text>`,
  )}<path d=${levelAt(floor)} stroke="#55585e" stroke-dasharray="2 3"/>${
    floor &&
    html`<text x=${RIGHT - 4} y=${px(yAt(floor) - 4)} text-anchor="end">rounding of a double</text>`
  }<text x=${RIGHT} y=${BOTTOM + 34} text-anchor="end">time, as a multiple of the exact outcome’s</text><text transform="translate(14 ${(TOP + BOTTOM) / 2}) rotate(-90)" text-anchor="middle">largest error of a velocity in m/s</text>${series}</svg>
`;
}
