/**
 * Draws a page's figures when a site is built, in V8 without a browser: the same skeleton and the same
 * classes as in the page, on a document made by linkedom. `cartsDraw(kind, values)` gives HTML.
 */

import { parseHTML } from "linkedom/worker";
import { standalone } from "../../view/cost/figure.js";
import { inside as costInside } from "../../view/cost/skeleton.js";
import { inside as hardInside } from "../../view/hard/skeleton.js";
import { scaleFor } from "../../view/map/bands.js";
import { palette, pixels } from "../../view/map/pixels.js";
import { inside as mapInside } from "../../view/map/skeleton.js";
import { inside as measuredInside } from "../../view/measured/skeleton.js";
import { heads } from "../../view/measured/units.js";
import { inside } from "../../view/skeleton/scene.js";
import { stage } from "../../view/skeleton/stage.js";
import { windowsOf } from "../../view/windows.js";
import { CostStage } from "./cost/stage.js";
import { Figure } from "./measured/figure.js";
import { bakedOf } from "./scene/baked.js";
import { Drawing } from "./scene/drawing.js";
import { Stage } from "./scene/stage.js";
import { need } from "./shared/dom.js";

const { document } = parseHTML("<!doctype html><html><body></body></html>");

/** @type {Record<string, (values: any) => string>} */
const KINDS = {
  scene,
  picture,
  cost,
  "cost-file": (values) => standalone(values).text,
  hard: (values) => hardInside(values).text,
  map: ({ facts, draw, picture }) => mapInside(facts, draw, picture).text,
  "map-picture": mapPicture,
  measured,
};

/** @param {{baked: Record<string, any>, found: boolean}} values @returns {string} the inside of `<carts-scene>` */
function scene({ baked: raw, found }) {
  const baked = bakedOf(raw);
  const root = filled("carts-scene", inside(baked, found).text);
  const drawing = new Drawing(root, baked);
  if (baked.fence.watch === "first") drawing.grow(0);
  drawing.show(baked.run, 0);
  drawing.at(0);
  for (const { table } of drawing.graphs) table.fill();
  for (const jump of root.querySelectorAll(".carts-jump")) jump.setAttribute("disabled", ""); // until a script answers
  return root.innerHTML.replaceAll("&#160;", "\u00a0");
}

/** @param {{baked: Record<string, any>, at: number}} values @returns {string} the narrow picture of a scene at an instant, in s */
function picture({ baked: raw, at }) {
  const baked = bakedOf(raw);
  const narrow = baked.view.layouts.filter(({ kind }) => kind === "narrow");
  const root = filled("div", narrow.map((layout) => stage(baked, layout).text).join(""));
  const drawing = new Stage(need(root, ".carts-stage"), baked);
  drawing.show(baked.run, windowsOf(baked.run));
  drawing.at(at);
  return root.innerHTML;
}

/** @param {import("../../view/cost/skeleton.js").Values} values @returns {string} the inside of `<carts-cost>`, at the end of its run */
function cost(values) {
  const root = filled("carts-cost", costInside(values).text);
  const stage = new CostStage(root);
  stage.show(values.run.header, values.run.numbers);
  stage.at(values.run.header.until);
  return root.innerHTML;
}

/**
 * The picture of a map for Python, which can pack a PNG file: a letter for each pixel, from “0” on.
 * @param {{low: number, high: number, columns: number, values: (number | null)[]}} values @returns {string} JSON
 */
function mapPicture({ low, high, columns, values }) {
  const scale = scaleFor(low, high);
  const known = Float64Array.from(values, (value) => value ?? Number.NaN);
  const { places, width, height } = pixels(known, columns, scale);
  const letters = Array.from(places, (place) => String.fromCharCode(48 + place)).join("");
  return JSON.stringify({ width, height, letters, palette: palette(scale) });
}

/** @param {import("../../view/measured/types.js").Facts} facts @returns {string} the inside of `<carts-measured>` */
function measured(facts) {
  const root = filled("carts-measured", measuredInside(facts).text);
  const [place, left] = [".carts-measured-figure", ".carts-measured-left"].map((one) =>
    need(root, one),
  );
  if (place && left && facts.read) {
    new Figure(place, left).show(facts.read.tracks, heads(facts.read), null);
  }
  return root.innerHTML;
}

/** @param {string} name of the element @param {string} markup of its inside */
function filled(name, markup) {
  const root = document.createElement(name);
  root.innerHTML = markup;
  document.body.replaceChildren(root);
  return root;
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
