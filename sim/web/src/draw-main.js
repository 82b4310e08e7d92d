/**
 * Draws a page's figures when a site is built, in V8 without a browser: the same skeleton and the same
 * classes as in the page, on a document made by linkedom. `cartsDraw(kind, values)` gives HTML.
 */

import { parseHTML } from "linkedom/worker";
import { inside } from "../../view/skeleton/scene.js";
import { bakedOf } from "./scene/baked.js";
import { Drawing } from "./scene/drawing.js";

const { document } = parseHTML("<!doctype html><html><body></body></html>");

/** @type {Record<string, (values: any) => string>} */
const KINDS = { scene };

/** @param {{baked: Record<string, any>, found: boolean}} values @returns {string} the inside of `<carts-scene>` */
function scene({ baked: raw, found }) {
  const baked = bakedOf(raw);
  const root = document.createElement("carts-scene");
  root.innerHTML = inside(baked, found).text;
  document.body.replaceChildren(root);
  const drawing = new Drawing(root, baked);
  drawing.show(baked.run, 0);
  drawing.at(0);
  for (const { table } of drawing.graphs) table.fill();
  for (const jump of root.querySelectorAll(".carts-jump")) jump.setAttribute("disabled", ""); // until a script answers
  return root.innerHTML.replaceAll("&#160;", "\u00a0");
}

/** @type {any} */ (globalThis).cartsDraw = (
  /** @type {string} */ kind,
  /** @type {any} */ values,
) => {
  const draw = KINDS[kind];
  /** @type {any} */ (globalThis).document = document; // for functions that make elements
  if (!draw) throw new Error(`nothing draws “${kind}”`);
  return draw(values);
};
