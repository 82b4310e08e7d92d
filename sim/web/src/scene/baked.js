/** What the generator baked into a scene element. */

import { fromBaked } from "../../../view/trajectory.js";
import { need } from "../shared/dom.js";

/** @param {HTMLElement} element @returns {import("../../../view/types.js").Baked} */
export function readBaked(element) {
  return bakedOf(JSON.parse(need(element, "script.carts-baked").textContent ?? ""));
}

/** @param {Record<string, any>} raw @returns {import("../../../view/types.js").Baked} */
export function bakedOf({ fence, view, numbers, ...header }) {
  const known = /** @type {import("../../../view/types.js").Header} */ (header);
  return { fence, view, run: { header: known, trajectory: fromBaked(numbers, known.events) } };
}
