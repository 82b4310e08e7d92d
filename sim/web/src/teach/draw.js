/** Draws the blocks that Python gives without a picture, by the same functions that the generator uses. */

import { scaleFor } from "../../../view/map/bands.js";
import { inside as mapInside } from "../../../view/map/skeleton.js";
import { inside as measuredInside } from "../../../view/measured/skeleton.js";
import { inside } from "../../../view/skeleton/scene.js";
import { paint } from "../map/paint.js";
import { bakedOf } from "../scene/baked.js";
import { need } from "../shared/dom.js";

/** @type {Record<string, (element: Element) => void>} by name of the element */
const DRAW = { "carts-scene": drawScene, "carts-map": drawMap, "carts-measured": drawMeasured };

/** What the element's own script takes over when it is put in the page. @param {Element} element of a block */
export function drawBlock(element) {
  if (element.firstElementChild?.localName === "script") DRAW[element.localName]?.(element);
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

/** @param {Element} element */
function drawMap(element) {
  /** @type {import("../../../view/map/types.js").MapFacts} */
  const facts = JSON.parse(need(element, ".carts-map-baked").textContent ?? "");
  const draw = facts.draw;
  if (!draw) return;
  let picture = "";
  if (facts.axes.length === 2) {
    const canvas = document.createElement("canvas");
    const columns = facts.axes[0]?.values.length ?? 0;
    const values = Float64Array.from(draw.values, (value) => value ?? Number.NaN);
    paint(canvas, { values, columns }, scaleFor(facts.low, facts.high));
    picture = canvas.toDataURL();
  }
  element.insertAdjacentHTML("afterbegin", mapInside(facts, draw, picture).text);
}

/** @param {Element} element */
function drawMeasured(element) {
  const facts = JSON.parse(need(element, ".carts-measured-baked").textContent ?? "");
  element.insertAdjacentHTML("afterbegin", measuredInside(facts).text);
}
