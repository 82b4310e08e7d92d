/** Small promises: the next frame, and one that is settled from outside. */

/** Resolves in the next animation frame, when what was drawn is on the screen. @returns {Promise<unknown>} */
export function frame() {
  return new Promise((resolve) => requestAnimationFrame(resolve));
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
  if (!first) return new Error("This value does not work.");
  return new Error(first.hint ? `${first.message}: ${first.hint}` : first.message);
}
