/** Draws the blocks that Python gives without a picture, by the same functions that the generator uses. */

import { inside } from "../../../view/skeleton/scene.js";
import { bakedOf } from "../scene/baked.js";
import { need } from "../shared/dom.js";

/** What the element's own script takes over when it is put in the page. @param {Element} element of a block */
export function drawBlock(element) {
  if (element.localName === "carts-scene" && !element.querySelector(".carts-frame")) {
    drawScene(element);
  }
}

/** @param {Element} element */
function drawScene(element) {
  const raw = JSON.parse(need(element, "script.carts-baked").textContent ?? "");
  const shown = /** @type {HTMLTemplateElement | null} */ (
    element.querySelector("template.carts-shown")
  );
  if (shown) {
    const open = { ...raw, ...JSON.parse(shown.dataset.baked ?? "{}") };
    shown.innerHTML = inside(bakedOf(open), true).text;
  }
  element.insertAdjacentHTML("afterbegin", inside(bakedOf(raw)).text);
}
