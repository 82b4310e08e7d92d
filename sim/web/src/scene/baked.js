/** What the generator baked into a scene element. */

import { fromBaked } from "../../../view/trajectory.js";
import { need } from "../shared/dom.js";

/** @param {HTMLElement} element @returns {import("../../../view/types.js").Baked} */
export function readBaked(element) {
  const { fence, view, numbers, ...header } = JSON.parse(
    need(element, "script.carts-baked").textContent ?? "",
  );
  return { fence, view, run: { header, trajectory: fromBaked(numbers, header.events) } };
}
