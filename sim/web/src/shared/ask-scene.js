/** What another element of the page asks of a scene's Python: the scene as it is set now, and a message. */

import { tr } from "../../../view/language.js";

export const ASKED = "carts-asked"; // an event of the scene

/**
 * @param {Element} scene @param {Record<string, unknown>} message as in `sim.bridge.protocol`
 * @returns {Promise<{header: any, numbers: Float64Array}>}
 */
export function askScene(scene, message) {
  /** @type {Promise<{header: any, numbers: Float64Array}> | null} */
  let answered = null;
  const answer = (/** @type {typeof answered} */ coming) => {
    answered = coming;
  };
  scene.dispatchEvent(new CustomEvent(ASKED, { detail: { message, answer } }));
  const unheard = tr("The scene does not answer. Load the page again.");
  return answered ?? Promise.reject(new Error(unheard));
}
