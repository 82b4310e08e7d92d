/** A run that drifts away, as somebody sees it who moves along. */

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/types.js").Baked} Baked */

/** The same picture, moving with the middle of the two: so they stay in it. @param {Baked} baked @param {Run} run @returns {Baked} */
export function alongWith(baked, { header }) {
  const mass = header.bodies.reduce((sum, body) => sum + body.mass, 0);
  const camera = header.bodies.reduce((sum, body) => sum + body.mass * body.velocity, 0) / mass;
  return { ...baked, fence: { ...baked.fence, camera } };
}
