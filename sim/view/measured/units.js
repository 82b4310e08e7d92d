/** Columns that name no unit: what was chosen for them, and what is still to be chosen. */

/** @typedef {import("./types.js").Read} Read */

const CHOOSE = {
  time: "what times are in",
  length: "what lengths are in",
  force: "what forces are in",
};

/** What readings of each kind are, and their unit. @type {Record<Read["kind"], [string, string]>} */
const QUANTITY = { length: ["x", "m"], force: ["F", "N"], acceleration: ["a", "m/s²"] };
const LETTERS = { time: "t", length: "x", force: "F" };

/** @param {Read} read */
const open = ({ assumed, chosen }) => assumed.filter((kind) => !chosen?.[kind]);

/** What is asked for. @param {Read} read @returns {string} empty: nothing */
export function missing(read) {
  const left = open(read).map((kind) => CHOOSE[kind]);
  return left.length ? `This file does not say its units. Choose ${left.join(" and ")}.` : "";
}

/** How it was read. @param {Read} read @returns {string[]} */
export const told = ({ assumed, chosen, read }) => [
  ...assumed.flatMap((kind) =>
    chosen?.[kind] ? `${LETTERS[kind]} in ${chosen[kind]} (as chosen)` : [],
  ),
  ...read,
];

/**
 * The heads of time and of each track; no unit stands where nobody has named one.
 * @param {Read} read
 * @returns {{time: string, value: string, tracks: string[]}}
 */
export function heads(read) {
  const [letter, unit] = QUANTITY[read.kind];
  const left = open(read);
  const its = left.some((kind) => kind === read.kind) ? "" : ` in ${unit}`;
  return {
    time: left.includes("time") ? "t" : "t in s",
    value: `${letter}${its}`,
    tracks: read.names.map((name) => `${letter} of ${name}${its}`),
  };
}
