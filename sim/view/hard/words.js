/** The cells of the table of hard cases, in words. */

import { short } from "../numbers.js";

/** @typedef {[string, number][]} Wanted what, and how much it must be */
/** @typedef {(number | null)[]} Got */

/** @type {Record<string, string>} */
const VERDICTS = {
  right: "right",
  "blows-up": "blows up",
  "passes-through": "carts pass through each other",
  misses: "misses contacts",
  "makes-energy": "makes energy from nothing",
  "loses-energy": "loses energy",
  sticks: "carts stick together",
  wrong: "wrong",
};
/** @type {Record<string, string>} */
const UNITS = { v: " m/s", x: " m", last: " s", count: "" };
/** @type {Record<string, string>} */
const NAMES = { warmed: "warmed the bumpers", count: "contacts", last: "last contact" };

export const LOADING = "Python’s numpy and scipy are being loaded …";
/** @param {number} done @param {number} of */
export const progressWords = (done, of) => `${done} of ${of}`;
/** @param {number} done */
export const stoppedWords = (done) => `Stopped after ${done} cases; the others are as prepared.`;
/** @param {number} good @param {number} of @param {number} seconds */
export const doneWords = (good, of, seconds) =>
  `${good} of ${of} came out as they must, just now in this browser; exact runs took ${short(seconds, 2)} s in all.`;
export const COPY = "Copy";
export const COPIED = "Copied";
export const KEPT = "What was prepared stays as it is.";

/** @param {string} what @returns {string} */
export function measure(what) {
  const { kind, name } = parts(what);
  if (kind === "v" || kind === "x") {
    const [last, first] = name.split("-");
    return first ? `${kind} of ${last} − ${kind} of ${first}` : `${kind} of ${name}`;
  }
  return NAMES[kind] ?? (kind === "work" ? `work of ${name}` : kind);
}

/** @param {string} what */
function parts(what) {
  const [kind = "", ...rest] = what.split(".");
  return { kind, name: rest.join(".") };
}

/** @param {string} what @param {number} value @param {number} figures */
function amount(what, value, figures) {
  const { kind } = parts(what);
  if (kind === "count") return String(Math.round(value));
  return short(value, figures) + (UNITS[kind] ?? " J");
}

/**
 * The number that is farthest off, and by how much; nothing if one is missing.
 * @param {Wanted} wanted @param {Got} got @param {number} figures
 */
function cameOut(wanted, got, figures) {
  let worst = "";
  let [error, came] = [0, 0];
  for (const [k, [what, right]] of wanted.entries()) {
    const value = got[k];
    if (value === null || value === undefined) return "";
    const distance = Math.abs(value - right);
    if (!worst || distance > error) [worst, error, came] = [what, distance, value];
  }
  const off = error ? `off by ${amount(worst, error, 2)}` : "no error";
  return `${measure(worst)}: ${amount(worst, came, figures)}, ${off}`;
}

/** @param {Wanted} wanted @param {{got: Got}} exact @returns {string} what came out exactly */
export function exactCell(wanted, { got }) {
  return cameOut(wanted, got, 6);
}

/** @param {Wanted} wanted @param {{verdict: string, got: Got}} stepped @returns {[string, string]} verdict, distance */
export function steppedCell(wanted, { verdict, got }) {
  return [VERDICTS[verdict] ?? verdict, verdict === "blows-up" ? "" : cameOut(wanted, got, 3)];
}

/** @type {Record<string, string>} stepping methods, in the order of the table's columns */
export const METHODS = { euler: "Euler", "semi-implicit": "semi-implicit Euler", rk4: "RK4" };
const MOST_TOLD = 3; // expected numbers told one by one; of fifty carts nobody reads all

/** @param {Wanted} wanted @returns {string[]} what must come out */
export function expectedLines(wanted) {
  const lines = wanted
    .slice(0, MOST_TOLD)
    .map(([what, value]) => `${measure(what)}: ${amount(what, value, 6)}`);
  const more = wanted.length - lines.length;
  return more ? [...lines, `and ${more} more`] : lines;
}
