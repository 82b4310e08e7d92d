/** Columns that name no unit: what was chosen for them, and what is still to be chosen. */

/** @typedef {import("./types.js").Read} Read */

const CHOOSE = {
  time: "what times are in",
  length: "what lengths are in",
  force: "what forces are in",
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
  const left = open(read).map((kind) => CHOOSE[kind]);
  return left.length ? `This file does not say its units. Choose ${left.join(" and ")}.` : "";
}

/** How it was read. @param {Read} read @returns {string[]} */
export const told = ({ assumed, chosen, read }) => [
  ...assumed.flatMap((kind) =>
    chosen?.[kind] ? `${QUANTITY[kind][0]} in ${chosen[kind]} (as chosen)` : [],
  ),
  ...read,
];

/**
 * The heads of time and of each track; no unit stands where nobody has named one.
 * @param {Read} read
 * @returns {{time: string, value: string, tracks: string[]}}
 */
export function heads(read) {
  const left = open(read);
  const named = (/** @type {Read["kind"] | "time"} */ kind, of = "") => {
    const [letter, unit] = QUANTITY[kind];
    return `${letter}${of}${left.some((one) => one === kind) ? "" : ` in ${unit}`}`;
  };
  return {
    time: named("time"),
    value: named(read.kind),
    tracks: read.names.map((name) => named(read.kind, ` of ${name}`)),
  };
}
