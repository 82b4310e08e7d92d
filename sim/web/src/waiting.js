/** Small promises: the next frame, and one that is settled from outside. */

import { heard, tr } from "./language.js";

/** Resolves in the next animation frame, when what was drawn is on the screen. @returns {Promise<unknown>} */
export function frame() {
  return new Promise((resolve) => requestAnimationFrame(resolve));
}

/**
 * Waits until a change is on the screen, measures how long that took, and tells whoever listens.
 * @param {HTMLElement} scene @param {number} at when the reader asked for it @param {object} detail the values now
 */
export async function drawn(scene, at, detail) {
  await frame();
  performance.measure("carts:update", { start: at, end: performance.now() });
  scene.dispatchEvent(new CustomEvent("carts-update", { bubbles: true, detail }));
}

/** @returns {{promise: Promise<unknown>, resolve: (value: unknown) => void, reject: (error: unknown) => void}} */
export function deferred() {
  /** @type {any} */
  const made = {};
  made.promise = new Promise((resolve, reject) => Object.assign(made, { resolve, reject }));
  return made;
}

/** @param {import("./types.js").Problem[]} problems @returns {Error} what a reader can do about it */
export function refusal(problems) {
  const [first] = problems;
  if (!first) return new Error(tr("This value does not work."));
  const message = heard(first.message);
  return new Error(first.hint ? `${message}: ${heard(first.hint)}` : message);
}
