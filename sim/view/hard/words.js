/** The cells of the table of hard cases, in words. */

import { tr } from "../language.js";
import { short } from "../numbers.js";

/** @typedef {[string, number][]} Wanted what, and how much it must be */
/** @typedef {(number | null)[]} Got */

/** @type {Record<string, string>} */
const VERDICTS = {
  right: tr("right"),
  "blows-up": tr("blows up"),
  "passes-through": tr("carts pass through each other"),
  misses: tr("misses contacts"),
  "makes-energy": tr("makes energy from nothing"),
  "loses-energy": tr("loses energy"),
  sticks: tr("carts stick together"),
  wrong: tr("wrong"),
};
/** @type {Record<string, string>} */
const UNITS = { v: " m/s", x: " m", last: " s", count: "" };
/** @type {Record<string, string>} */
const NAMES = {
  warmed: tr("warmed the bumpers"),
  count: tr("contacts"),
  last: tr("last contact"),
};

export const LOADING = tr("Python’s numpy and scipy are being loaded …");
/** @param {number} done @param {number} of */
export const progressWords = (done, of) => tr("{done} of {all}", { done, all: of });
/** @param {number} n */
export const stoppedWords = (n) =>
  tr("Stopped after {n} cases; the others are as prepared.", { n });
/** @param {number} good @param {number} of @param {number} seconds */
export const doneWords = (good, of, seconds) =>
  tr(
    "{good} of {all} came out as they must, just now in this browser; exact runs took {seconds} s in all.",
    { good, all: of, seconds: short(seconds, 2) },
  );
export const COPY = tr("Copy");
export const COPIED = tr("Copied");
/** @param {string} reason */
export const keptWords = (reason) => tr("{reason} What was prepared stays as it is.", { reason });

/** @param {string} what @returns {string} */
export function measure(what) {
  const { kind, name } = parts(what);
  if (kind === "v" || kind === "x") {
    const [last, first] = name.split("-");
    const of = (/** @type {string} */ cart = "") =>
      tr("{letter} of {cart}", { letter: kind, cart });
    return first ? `${of(last)} − ${of(first)}` : of(name);
  }
  return NAMES[kind] ?? (kind === "work" ? tr("work of {name}", { name }) : kind);
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
  return (short(value, figures) + (UNITS[kind] ?? " J")).replaceAll(" ", "\u00a0"); // of one piece
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
  const off = error ? tr("off by {amount}", { amount: amount(worst, error, 2) }) : tr("no error");
  return tr("{quantity}: {amount}, {off}", {
    quantity: measure(worst),
    amount: amount(worst, came, figures),
    off,
  });
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
export const METHODS = { euler: "Euler", "semi-implicit": tr("semi-implicit Euler"), rk4: "RK4" };
const MOST_TOLD = 3; // expected numbers told one by one; of fifty carts nobody reads all

/** @param {Wanted} wanted @returns {string[]} what must come out */
export function expectedLines(wanted) {
  const lines = wanted
    .slice(0, MOST_TOLD)
    .map(([what, value]) =>
      tr("{quantity}: {amount}", { quantity: measure(what), amount: amount(what, value, 6) }),
    );
  const more = wanted.length - lines.length;
  return more ? [...lines, tr("and {n} more", { n: more })] : lines;
}
