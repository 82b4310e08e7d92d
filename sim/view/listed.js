/** Lists as a sentence has them. */

import { tr } from "./language.js";

/** @param {string[]} names @returns {string} “A”, “A and B”, “A, B and C” */
export function listed(names) {
  const [first = "", second] = names;
  if (second === undefined) return first;
  const rest = names.slice(0, -1).join(", ");
  return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
}
