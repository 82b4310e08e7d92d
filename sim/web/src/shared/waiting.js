/** Small promises: the next frame, one that is settled from outside; how long a reader waited. */

import { told, tr } from "../../../view/language.js";

/** Resolves in the next animation frame, when what was drawn is on the screen. @returns {Promise<unknown>} */
export function frame() {
  return new Promise((resolve) => requestAnimationFrame(resolve));
}

/** An event of a scene: its values are those that it came with. */
export const RESET = "carts-reset";

/** Measures of one name are kept up to here: the browser keeps each for ever, at some kB apiece. */
const MEASURES = 200;

/** Notes how long a reader has waited for what is on the screen now. @param {string} name @param {number} at */
export function waited(name, at) {
  if (performance.getEntriesByName(name).length >= MEASURES) performance.clearMeasures(name);
  performance.measure(name, { start: at, end: performance.now() });
}

/**
 * Waits until a change is on the screen, measures how long that took, and tells whoever listens.
 * @param {HTMLElement} scene @param {number} at when the reader asked for it @param {object} detail the values now
 */
export async function drawn(scene, at, detail) {
  await frame();
  waited("carts:update", at);
  scene.dispatchEvent(new CustomEvent("carts-update", { bubbles: true, detail }));
}

/** @returns {{promise: Promise<unknown>, resolve: (value: unknown) => void, reject: (error: unknown) => void}} */
export function deferred() {
  /** @type {any} */
  const made = {};
  made.promise = new Promise((resolve, reject) => Object.assign(made, { resolve, reject }));
  return made;
}

/** @param {import("../../../view/types.js").Problem[]} problems @returns {Error & {path?: (string | number)[]}} what a reader can do about it, and where */
export function refusal(problems) {
  const [first] = problems;
  if (!first) return new Error(tr("This value does not work."));
  const message = told(first.message);
  const text = first.hint ? `${message}: ${told(first.hint)}` : message;
  return Object.assign(new Error(text), { path: first.path, refused: true });
}
