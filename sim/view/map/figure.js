/**
 * The figure of a map: its plot with numbers on both axes; for two axes below it the bands with theirs.
 *
 *     +---------------------------+
 *     |  picture, or a curve      |
 *     +---------------------------+
 *       numbers of the first axis
 *     [ bands with their numbers ]
 */

import { html } from "../markup.js";
import { fixed, px } from "../numbers.js";
import { axis, axisDecimals, span, ticks } from "../scales.js";
import { edgeDecimals, edges, scaleFor } from "./bands.js";
import { torn } from "./pixels.js";
import { named, shown } from "./words.js";

/** @typedef {import("./types.js").MapFacts} MapFacts */
/** @typedef {import("../scales.js").Axis} Axis */

export const [LEFT, TOP, RIGHT, BOTTOM] = [58, 10, 388, 270];
export const WIDTH = 400;
const [HEIGHT, HEIGHT_OF_CURVE] = [370, 312];
const [BAR_TOP, BAR_HEIGHT] = [322, 12];
const TICKS = 5;
const MOST_NUMBERS = 7; // at the bands; more would touch each other
const BASELINE = 4; // from a tick to the foot of its number

/** @param {MapFacts} facts */
export const heightOf = ({ axes }) => (axes.length === 1 ? HEIGHT_OF_CURVE : HEIGHT);

/** @param {MapFacts} facts @returns {Axis} of the values of a curve; it covers zero and all that the sliders reach */
export const valueAxis = ({ low, high }) => axis(low, high, TICKS);

/** @param {number} value @param {Axis} axis @returns {number} drawing coordinate along the first axis */
export function across(value, { low, high }) {
  return LEFT + (value - low) * ((RIGHT - LEFT) / (high - low));
}

/** @param {number} value @param {Axis} axis @returns {number} drawing coordinate along the second axis */
export function up(value, { low, high }) {
  return BOTTOM - (value - low) * ((BOTTOM - TOP) / (high - low));
}

/** The curve of a map over one number; it breaks where there is no value, at a jump, and beyond the axis. @param {MapFacts} facts @param {number[]} points SI @param {ArrayLike<number>} values @returns {string} */
export function curve(facts, points, values) {
  const along = facts.axes[0];
  if (!along) return "";
  const [x, y] = [span(along.low, along.high, 1), valueAxis(facts)];
  let path = "";
  let pen = "M";
  for (const [k, point] of points.entries()) {
    const [before, last, value, next] = [k - 2, k - 1, k, k + 1].map((at) => Number(values[at]));
    if (torn(before, last, value, next, (y.high - y.low) / TICKS)) pen = "M";
    if (value >= y.low && value <= y.high) {
      path += `${pen}${px(across(shown(point, along), x))} ${px(up(value, y))}`;
      pen = "L";
    } else pen = "M";
  }
  return path;
}

/** The part below the cross: picture, grid, numbers, bands. @param {MapFacts} facts @param {string} picture address; empty for a curve */
export function under(facts, picture) {
  const [first, second] = facts.axes;
  const x = span(first?.low ?? 0, first?.high ?? 1, TICKS);
  const y = second ? span(second.low, second.high, TICKS) : valueAxis(facts);
  const labels = [first ? named(first) : "", second ? named(second) : named(facts)];
  const height = heightOf(facts);
  const [bottom, right] = picture ? [BOTTOM, LEFT] : [TOP, RIGHT];
  const image = html`<image href=${picture} x=${LEFT} y=${TOP} width=${RIGHT - LEFT} height=${BOTTOM - TOP} preserveAspectRatio="none"/>
`;
  const columns = ticks(x).map((tick) => {
    const at = px(across(tick, x));
    return html`<path class="carts-grid" d="M${at} ${bottom}V${BOTTOM + 4}"/><text class="carts-tick-x" x=${at} y=${BOTTOM + 16}>${fixed(tick, axisDecimals(x))}</text>`;
  });
  const rows = ticks(y).map((tick) => {
    const at = up(tick, y);
    return html`<path class="carts-grid" d="M${LEFT - 4} ${px(at)}H${right}"/><text class="carts-tick-y" x=${LEFT - 7} y=${px(at + BASELINE)}>${fixed(tick, axisDecimals(y))}</text>`;
  });
  return html`<svg class="carts-map-under" viewBox="0 0 ${WIDTH} ${height}" width=${WIDTH} height=${height} aria-hidden="true" focusable="false">
${picture !== "" && image}${columns}
${rows}
<text class="carts-unit" x=${RIGHT} y=${BOTTOM + 31} text-anchor="end">${labels[0]}</text>
<text class="carts-unit" transform="translate(13 ${(TOP + BOTTOM) / 2}) rotate(-90)" text-anchor="middle">${labels[1]}</text>
${second && bar(facts)}
</svg>`;
}

/** The bands of the scale from low to high, with the numbers between them. @param {MapFacts} facts */
function bar(facts) {
  const scale = scaleFor(facts.low, facts.high);
  const width = (RIGHT - LEFT) / scale.count;
  const numbers = edges(scale);
  const every = Math.ceil(scale.count / MOST_NUMBERS);
  const zero = Math.max(
    0,
    numbers.findIndex((number) => Math.abs(number) < 0.5 * scale.step),
  );
  const parts = numbers.map((number, k) => {
    const x = px(LEFT + k * width, 2);
    const colour = scale.colours[k];
    const band =
      colour &&
      html`<rect x=${x} y=${BAR_TOP} width=${px(width, 2)} height=${BAR_HEIGHT} fill=${hex(colour)}/>`;
    const notch =
      (k - zero) % every === 0 &&
      html`<path class="carts-map-notch" d="M${x} ${BAR_TOP}v${BAR_HEIGHT}"/><text class="carts-tick-x" x=${x} y=${BAR_TOP + BAR_HEIGHT + 12}>${fixed(number, edgeDecimals(scale))}</text>`;
    return html`${band}${notch}`;
  });
  return html`${parts}
<text class="carts-unit" x=${RIGHT} y=${BAR_TOP + BAR_HEIGHT + 26} text-anchor="end">${named(facts)}</text>`;
}

/** @param {import("./palette.js").Colour} colour */
const hex = (colour) => `#${colour.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
