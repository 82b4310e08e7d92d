/**
 * What each cart did, as spans of time, and how boundaries between them move. No page is needed here.
 * A contact is one of both carts, so its boundaries move for both.
 *
 * @typedef {import("../../../view/measured/types.js").Segment} Segment
 * @typedef {import("../../../view/measured/types.js").Given} Given
 */

const SAME = 1e-6; // s; boundaries that are one
const LEAST = 2; // steps that a span keeps

/** @param {Segment[]} segments @param {string} cart @returns {Segment[]} in order of time */
export function ofCart(segments, cart) {
  return segments.filter((one) => one.cart === cart);
}

/**
 * How far the boundary after the span `k` of a cart may go.
 * @param {Segment[]} segments @param {string} cart @param {number} k @param {number} step s
 * @returns {[number, number]}
 */
export function limits(segments, cart, k, step) {
  const all = linked(segments, cart, k);
  const low = Math.max(...all.map(([left]) => left.from + LEAST * step));
  const high = Math.min(...all.map(([, right]) => right.until - LEAST * step));
  return [low, Math.max(low, high)];
}

/**
 * The spans on both sides of a boundary, of every cart that shares it.
 * @param {Segment[]} segments @param {string} cart @param {number} k @returns {[Segment, Segment][]}
 */
function linked(segments, cart, k) {
  const own = ofCart(segments, cart);
  const [left, right] = [own[k], own[k + 1]];
  if (!left || !right) return [];
  const push = left.kind === "contact" ? "left" : right.kind === "contact" ? "right" : "";
  if (!push) return [[left, right]];
  const at = left.until;
  /** @type {[Segment, Segment][]} */
  const found = [];
  for (const one of segments) {
    if (Math.abs(one.until - at) > SAME) continue;
    const other = segments.find((s) => s.cart === one.cart && Math.abs(s.from - at) <= SAME);
    if (other && (push === "left" ? one : other).kind === "contact") found.push([one, other]);
  }
  return found;
}

/**
 * Moves the boundary after the span `k` of a cart.
 * @param {Segment[]} segments changed in place @param {string} cart @param {number} k @param {number} t s
 */
export function move(segments, cart, k, t) {
  for (const [left, right] of linked(segments, cart, k)) {
    left.until = t;
    right.from = t;
  }
}

/**
 * What is to be told of a boundary that was moved, after what was told before.
 * @param {Given[]} before @param {Segment[]} segments @param {string} cart @param {number} k @returns {Given[]}
 */
export function told(before, segments, cart, k) {
  const own = ofCart(segments, cart);
  const sides = [own[k], own[k + 1]].filter((one) => one !== undefined);
  const push = sides.find((one) => one.kind === "contact");
  const rows = (push ? [push] : sides).map(({ kind, from, until }) => {
    return { kind, from, until, cart: push ? null : cart };
  });
  const replaced = (/** @type {Given} */ old) =>
    rows.some((row) => row.cart === old.cart && row.from < old.until && old.from < row.until);
  return [...before.filter((old) => !replaced(old)), ...rows];
}

/**
 * Rows for handles, so that none lies over another.
 * @param {number[]} places px, rising @param {number} wide px @returns {number[]} the row of each, from 0
 */
export function lanes(places, wide) {
  /** @type {number[]} */
  const ends = [];
  return places.map((x) => {
    const free = ends.findIndex((end) => end <= x - wide / 2);
    const row = free < 0 ? ends.length : free;
    ends[row] = x + wide / 2;
    return row;
  });
}
