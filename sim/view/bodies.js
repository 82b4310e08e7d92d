/** How bodies are named: carts by their letters, the ends of the track as walls. */

import { tr } from "./language.js";

/** @param {string} name */
export function isWall(name) {
  return name === "left" || name === "right";
}

/** @param {string} name @returns {string} a body as a sentence names it */
export function body(name) {
  if (name === "left") return tr("the left wall");
  return name === "right" ? tr("the right wall") : name;
}

/** @param {string} name @returns {string} a body as a label names it */
export function brief(name) {
  if (name === "left") return tr("left wall");
  return name === "right" ? tr("right wall") : name;
}

/** @param {string} on @param {string} by @returns {string} both bodies as a sentence names them */
export function forceOn(on, by) {
  return tr("force on {on} by {by}", { on, by });
}

/** @param {string[]} names @returns {string} “A”, “A and B”, “A, B and C” */
export function listed(names) {
  const [first = "", second] = names;
  if (second === undefined) return first;
  const rest = names.slice(0, -1).join(", ");
  return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
}
