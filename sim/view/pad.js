/** The pad on which a curve is predicted: its geometry, one for forces and one for what has a direction. */

import { px } from "./numbers.js";

export const LEFT = 40;
export const STEP = 77.5; // from one point to the next
export const POINTS = 5;
export const HIGHEST = 10; // steps of height
const TOP = 10;
const BOTTOM = 130;

/** @typedef {{low: number, zero: number, per: number}} Pad lowest height, place of zero, drawing units per step of height */

/** @param {"F" | "v" | "x"} quantity @returns {Pad} a force has a size, velocity and displacement a direction */
export function pad(quantity) {
  const low = quantity === "F" ? 0 : -HIGHEST;
  const per = (BOTTOM - TOP) / (HIGHEST - low);
  return { low, zero: TOP + HIGHEST * per, per };
}

/** @param {Pad} pad @param {ArrayLike<number>} heights evenly over the time @returns {string} path */
export function path({ zero, per }, heights) {
  const step = ((POINTS - 1) * STEP) / (heights.length - 1);
  const points = Array.from(
    heights,
    (height, k) => `${px(LEFT + k * step)} ${px(zero - per * height)}`,
  );
  return `M${points.join("L")}`;
}
