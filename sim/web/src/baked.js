/** What the generator baked into a scene element. */

import { need } from "./dom.js";
import { fromBaked } from "./trajectory.js";

/** @param {HTMLElement} element @returns {import("./types.js").Baked} */
export function readBaked(element) {
  const { fence, view, numbers, ...header } = JSON.parse(
    need(element, "script.carts-baked").textContent ?? "",
  );
  return { fence, view, run: { header, trajectory: fromBaked(numbers, header.events) } };
}
