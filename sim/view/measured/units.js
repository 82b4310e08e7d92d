/** Columns that name no unit: what was chosen for them, and what is still to be chosen. */

import { listed } from "../bodies.js";
import { told, tr } from "../language.js";

/** @typedef {import("./types.js").Read} Read */

/** @type {Record<Read["assumed"][number], () => string>} */
const CHOOSE = {
  time: () => tr("what times are in"),
  length: () => tr("what lengths are in"),
  force: () => tr("what forces are in"),
};

/** What readings of each kind are, and their unit. @type {Record<Read["kind"] | "time", [string, string]>} */
const QUANTITY = {
  time: ["t", "s"],
  length: ["x", "m"],
  force: ["F", "N"],
  acceleration: ["a", "m/s²"],
};

/** @param {Read} read */
const open = ({ assumed, chosen }) => assumed.filter((kind) => !chosen?.[kind]);

/** What is asked for. @param {Read} read @returns {string} empty: nothing */
export function missing(read) {
  const left = open(read).map((kind) => CHOOSE[kind]());
  if (!left.length) return "";
  return tr("This file does not say its units. Choose {what}.", { what: listed(left) });
}

/** How it was read. @param {Read} read @returns {string[]} */
export const howRead = ({ assumed, chosen, read }) => [
  ...assumed.flatMap((kind) =>
    chosen?.[kind]
      ? tr("{letter} in {unit} (as chosen)", { letter: QUANTITY[kind][0], unit: chosen[kind] })
      : [],
  ),
  ...read.map(told),
];

/**
 * The heads of time and of each track; no unit stands where nobody has named one.
 * @param {Read} read
 * @returns {{time: string, value: string, tracks: string[]}}
 */
export function heads(read) {
  const left = open(read);
  const named = (/** @type {Read["kind"] | "time"} */ kind, cart = "") => {
    const [letter, unit] = QUANTITY[kind];
    const what = cart ? tr("{letter} of {cart}", { letter, cart }) : letter;
    return left.some((one) => one === kind)
      ? what
      : tr("{letter} in {unit}", { letter: what, unit });
  };
  return {
    time: named("time"),
    value: named(read.kind),
    tracks: read.names.map((name) => named(read.kind, name)),
  };
}

/** Parts of a line, told one after the other. @param {string[]} parts @returns {string} */
export function semicolons([first = "", ...rest]) {
  return rest.reduce((before, then) => tr("{first}; {then}", { first: before, then }), first);
}
