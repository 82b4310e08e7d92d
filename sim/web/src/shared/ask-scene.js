/** What another element of the page asks of a scene's Python: the scene as it is set now, and a message. */

export const ASKED = "carts-asked"; // an event of the scene

/**
 * @param {Element} scene @param {Record<string, unknown>} message as in `sim.bridge.protocol`
 * @returns {Promise<{header: any, numbers: Float64Array}>}
 */
export function askScene(scene, message) {
  return new Promise((answer) => {
    scene.dispatchEvent(new CustomEvent(ASKED, { detail: { message, answer } }));
  });
}
