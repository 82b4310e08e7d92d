/** A graph against time as SVG attributes. */

import { exponent, fixed, px } from "./numbers.js";
import { axis, axisDecimals, span, ticks } from "./scales.js";
import { turnAfter, valueAt } from "./trajectory.js";

/** @typedef {import("./scales.js").Axis} Axis */
/** @typedef {import("./series.js").Series} Series */
/** @typedef {{time: Axis, value: Axis}} Plane */

export const LEFT = 52;
export const RIGHT = 350;
export const TOP = 8;
export const BOTTOM = 127;
export const WIDTH = 360;
export const HEIGHT = 160;
export const GAP = 5; // units between the numbers of the values and their axis
const WIDEST = 9.2; // units, the width of a figure in the larger letters of a phone
const LETTER = 8; // units, the width of a figure; a point takes half
const BELOW_LINE = 5; // units, from a grid line to the foot of its number
const [FEW, ENOUGH, MANY] = [5, 4, 8]; // numbers beside an axis: at most, at least, and where those are too few
const HARDLY = 0.05; // of the values; a curve no further beyond zero needs no number there
const NEAR = 0.7; // units; rows nearer than this to the last drawn one are left out
const LONG = 8; // units along the time axis
const PIECES = 8; // straight ones, in place of the part of a bend that was seen
const STRAIGHT = 0.05; // units; a curve that bends less is drawn as a line

/** @param {Plane} plane @param {number} t @returns {number} drawing coordinate of a time in s */
export function timeX(plane, t) {
  return LEFT + (t - plane.time.low) * ((RIGHT - LEFT) / (plane.time.high - plane.time.low));
}

/** @param {Plane} plane @param {number} value @returns {number} drawing coordinate of a value */
export function valueY(plane, value) {
  return (
    BOTTOM - (value - plane.value.low) * ((BOTTOM - TOP) / (plane.value.high - plane.value.low))
  );
}

/** @param {Series[]} curves @param {ArrayLike<number>} times of their rows @returns {[number, number]} smallest and greatest value of all, between rows too */
export function extent(curves, times) {
  let low = 0;
  let high = 0;
  const take = (/** @type {number} */ value) => {
    if (value < low) low = value;
    if (value > high) high = value;
  };
  for (const { values, slopes } of curves) {
    for (let k = 0; k < values.length; k += 1) {
      take(Number(values[k]));
      const turned = turnAfter(times, values, slopes, k);
      if (turned !== null) take(turned);
    }
  }
  return [low, high];
}

/**
 * How far an axis goes: as far as the sliders may take it, but not so far that the run gets small.
 * @param {[number, number]} run its smallest and greatest value
 * @param {[number, number, number, number]} reach limits, stretch, room @param {boolean} mirrored below zero too
 * @returns {[number, number]}
 */
export function reached(run, [low, high, factor, room], mirrored = false) {
  const down = Math.min(run[0] * factor, mirrored ? -high : low);
  const up = Math.max(run[1] * factor, high);
  const most = room * Math.max(-run[0], run[1]);
  return most > 0 ? [Math.max(down, -most), Math.min(up, most)] : [down, up];
}

/**
 * Axes that cover zero and all the values; `window` is a part of the time.
 * @param {[number, number]} values @param {[number, number]} window in s @returns {Plane}
 */
export function planeFor(values, window) {
  return { time: span(window[0], window[1], 6), value: readable(values[0], values[1]) };
}

/** Some more numbers where there would be few, or none on one side of zero. @param {number} low @param {number} high @returns {Axis} */
function readable(low, high) {
  const plain = axis(low, high, FEW);
  const found = ticks(plain);
  const hardly = HARDLY * (high - low);
  const sides =
    (low >= -hardly || found.some((v) => v < 0)) && (high <= hardly || found.some((v) => v > 0));
  return found.length >= ENOUGH && sides ? plain : axis(low, high, MANY);
}

/**
 * @param {Series} curve @param {ArrayLike<number>} times @param {Plane} plane
 * @param {number} seen s, as far as it is drawn @returns {string} the SVG path
 */
export function path(curve, times, plane, seen = Infinity) {
  const { values, slopes } = curve;
  const kx = (RIGHT - LEFT) / (plane.time.high - plane.time.low);
  const ky = (BOTTOM - TOP) / (plane.value.high - plane.value.low);
  const last = times.length - 1;
  let drawn = 0;
  let x0 = timeX(plane, Number(times[0]));
  let y0 = valueY(plane, Number(values[0]));
  let d = `M${px(x0)} ${px(y0)}`;
  /** Of a crowd the last row is drawn where a long piece follows: free flight begins at its own height. @param {number} k @param {number} x */
  const isLong = (k, x) => k < last && timeX(plane, Number(times[k + 1])) - x > LONG;
  for (let k = 1; k <= last; k += 1) {
    if (Number(times[k]) > seen) return d + tail(curve, times, plane, Number(times[k - 1]), seen);
    const x = timeX(plane, Number(times[k]));
    const y = valueY(plane, Number(values[k]));
    const near = Math.abs(x - x0) < NEAR && Math.abs(y - y0) < NEAR;
    if (k < last && near && !isLong(k, x)) continue;
    const third = (Number(times[k]) - Number(times[k - 1])) / 3;
    let bent = false;
    if (slopes && drawn === k - 1 && third > 0) {
      const [x1, x2] = [x0 + third * kx, x - third * kx];
      const y1 = y0 - Number(slopes[k - 1]) * third * ky;
      const y2 = y + Number(slopes[k]) * third * ky;
      bent =
        Math.abs(y1 - (2 * y0 + y) / 3) > STRAIGHT || Math.abs(y2 - (y0 + 2 * y) / 3) > STRAIGHT;
      if (bent) d += `C${px(x1)} ${px(y1)} ${px(x2)} ${px(y2)} ${px(x)} ${px(y)}`;
    }
    if (!bent) d += `L${px(x)} ${px(y)}`;
    drawn = k;
    x0 = x;
    y0 = y;
  }
  return d;
}

/** The last piece of a curve, from a row to an instant before the next. @param {Series} curve @param {ArrayLike<number>} times @param {Plane} plane @param {number} from in s @param {number} to in s */
function tail({ values, slopes }, times, plane, from, to) {
  let d = "";
  for (let k = 1; k <= PIECES; k += 1) {
    const t = from + ((to - from) * k) / PIECES;
    d += `L${px(timeX(plane, t))} ${px(valueY(plane, valueAt(times, values, slopes, t)))}`;
  }
  return d;
}

/** @param {Plane} plane @returns {{at: string, textX: string, label: string}[]} vertical grid lines; the last number stays in the picture */
export function timeMarks(plane) {
  const decimals = axisDecimals(plane.time);
  return ticks(plane.time).map((t) => {
    const at = timeX(plane, t);
    const label = fixed(t, decimals);
    const wide = LETTER * (label.length - (decimals > 0 ? 0.5 : 0));
    return { at: px(at), textX: px(Math.min(at, WIDTH - wide / 2)), label };
  });
}

/** @param {Plane} plane @returns {{at: string, textY: string, label: string, zero: boolean}[]} horizontal grid lines, their numbers without the power of ten of all */
export function valueMarks(plane) {
  const power = valuePower(plane);
  const decimals = power ? power - exponent(plane.value.step) : axisDecimals(plane.value);
  return ticks(plane.value).map((v) => ({
    at: px(valueY(plane, v)),
    textY: px(valueY(plane, v) + BELOW_LINE),
    label: fixed(v / Number(`1e${power}`), Math.max(0, decimals)),
    zero: v === 0,
  }));
}

/** @param {Plane} plane @returns {number} the power of ten that stands beside an axis whose numbers have no room; 0: they have */
export function valuePower({ value }) {
  const decimals = axisDecimals(value);
  const widths = ticks(value).map(
    (v) => WIDEST * (fixed(v, decimals).length - (decimals ? 0.5 : 0)),
  );
  if (Math.max(...widths) <= LEFT - GAP) return 0;
  return exponent(Math.max(Math.abs(value.low), Math.abs(value.high)));
}
