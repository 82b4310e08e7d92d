/** How bodies are named: carts by their letters, the ends of the track by what stands there. */

import { inRow, tr } from "./language.js";

/** @typedef {import("./types.js").Track} Track */

/** @type {Record<string, () => {body: string, brief: string}>} what may stand at an end instead of a wall */
const THINGS = {
  foam: () => ({ body: tr("the foam"), brief: tr("foam") }),
  spring: () => ({ body: tr("the spring"), brief: tr("spring") }),
  board: () => ({ body: tr("the board"), brief: tr("board") }),
};

/** @param {string} name */
export function isWall(name) {
  return name === "left" || name === "right";
}

/** @param {string} name of an end @param {Track} track @returns {string} what stands there: “wall” or the name of a thing */
export function whatIs(name, { left_is = "wall", right_is = "wall" }) {
  return name === "left" ? left_is : right_is;
}

/** @param {string} name @param {Track} track @returns {string} a body as a sentence, and the name of a force, calls it; the only wall needs no side */
export function body(name, track) {
  if (!isWall(name)) return name;
  const thing = thingAt(name, track, "body");
  if (thing) return thing;
  if (!hasTwoWalls(track)) return tr("the wall");
  return name === "left" ? tr("the left wall") : tr("the right wall");
}

/** @param {string} name @param {Track} track @returns {string} a body as a label names it */
export function brief(name, track) {
  if (!isWall(name)) return name;
  const thing = thingAt(name, track, "brief");
  if (thing) return thing;
  if (!hasTwoWalls(track)) return tr("wall");
  return name === "left" ? tr("left wall") : tr("right wall");
}

/** @param {Track} track */
function hasTwoWalls(track) {
  return ["left", "right"].every(
    (side) =>
      track[/** @type {"left" | "right"} */ (side)] === "wall" && whatIs(side, track) === "wall",
  );
}

/** @param {string} name of a cart @returns {boolean} whether it says what it is, as “truck” does and A does not */
export function isWord(name) {
  return name.length > 2;
}

/** @param {string} name of an end @param {Track} track @returns {string} what it is, where it need not be told from the other */
export function kind(name, track) {
  return THINGS[whatIs(name, track)]?.().brief ?? tr("wall");
}

/** @param {string} name of an end @param {Track} track @param {"body" | "brief"} form @returns {string} "" where a wall stands */
function thingAt(name, track, form) {
  const thing = THINGS[whatIs(name, track)]?.()[form];
  if (!thing || whatIs("left", track) !== whatIs("right", track)) return thing ?? "";
  return name === "left"
    ? tr("{thing} on the left", { thing })
    : tr("{thing} on the right", { thing });
}

/** @param {string} on @param {string} by @returns {string} both bodies as a sentence names them */
export function forceOn(on, by) {
  return tr("force on {on} by {by}", { on, by });
}

/** @param {string[]} names @returns {string} “A”, “A and B”, “A, B and C” */
export function listed(names) {
  const [first = "", second] = names;
  if (second === undefined) return first;
  const rest = inRow(names.slice(0, -1));
  return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
}

/** @param {string} on @param {string} by @param {Track} track @returns {string} a force, as a label names both bodies */
export function onBy(on, by, track) {
  return tr("on {on} by {by}", { on: body(on, track), by: body(by, track) });
}

/** @param {string[]} names @param {Track} track @returns {string} “A–B”: bodies of a contact, as a label names them */
export function dashed(names, track) {
  return names.map((name) => brief(name, track)).join("–");
}

/** @param {string[]} names @param {Track} track @returns {string} bodies of a contact, as a sentence names them */
export function bodiesOf(names, track) {
  return listed(names.map((name) => body(name, track)));
}
