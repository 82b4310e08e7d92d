/** The figure of a map: canvas or curve, and the cross that marks a point. */

import { scaleFor } from "../../../view/map/bands.js";
import * as g from "../../../view/map/figure.js";
import { shown } from "../../../view/map/words.js";
import { px } from "../../../view/numbers.js";
import { span } from "../../../view/scales.js";
import { html, need, put } from "../shared/dom.js";
import { onPointed } from "../shared/follow.js";
import { paint } from "./paint.js";

/** @typedef {import("../../../view/map/types.js").MapFacts} MapFacts */
/** @typedef {import("../../../view/map/types.js").Grid} Grid */

export class MapFigure {
  /** @type {HTMLCanvasElement | null} */
  #canvas = null;

  /** @param {HTMLElement} root @param {MapFacts} facts @param {(places: number[]) => void} point */
  constructor(root, facts, point) {
    this.facts = facts;
    this.scale = scaleFor(facts.low, facts.high);
    this.height = g.heightOf(facts);
    this.holder = need(root, ".carts-map-figure");
    /** @type {SVGElement} */
    this.over = need(root, ".carts-map-over");
    /** @type {number[][]} */
    this.axes = facts.axes.map(({ values }) => values);
    onPointed(this.over, (event) => {
      if (this.#canvas || facts.axes.length < 2) point(this.#placesAt(event));
    });
  }

  /** @param {Grid} grid */
  show(grid) {
    this.axes = grid.axes;
    if (grid.axes.length === 1) {
      const path = g.curve(this.facts, grid.axes[0] ?? [], grid.values);
      return put(need(this.over, '[data-part="curve"]'), "d", path);
    }
    this.#canvas ??= this.#laid();
    paint(this.#canvas, grid, this.scale);
  }

  /** @param {number[]} places @param {number} value */
  mark(places, value) {
    const x = this.#along(0, places[0] ?? 0, g.across);
    const flat = places.length === 1;
    const y = flat ? g.up(value, g.valueAxis(this.facts)) : this.#along(1, places[1] ?? 0, g.up);
    const across = flat ? "" : `M${g.LEFT} ${px(y)}H${g.RIGHT}`;
    put(need(this.over, '[data-part="lines"]'), "d", `M${px(x)} ${g.TOP}V${g.BOTTOM}${across}`);
    const point = need(this.over, '[data-part="point"]');
    put(point, "cx", px(x));
    put(point, "cy", px(Number.isNaN(y) ? g.BOTTOM : y));
    put(point, "visibility", Number.isNaN(y) ? "hidden" : "visible");
  }

  /** The canvas lies between the picture, which it hides, and the cross. */
  #laid() {
    const canvas = /** @type {HTMLCanvasElement} */ (html("canvas", "carts-map-canvas"));
    canvas.setAttribute("aria-hidden", "true");
    canvas.style.left = `${(100 * g.LEFT) / g.WIDTH}%`;
    canvas.style.top = `${(100 * g.TOP) / this.height}%`;
    canvas.style.width = `${(100 * (g.RIGHT - g.LEFT)) / g.WIDTH}%`;
    canvas.style.height = `${(100 * (g.BOTTOM - g.TOP)) / this.height}%`;
    this.over.before(canvas);
    return canvas;
  }

  /** @param {number} k axis @param {number} place @param {typeof g.across} draw @returns {number} drawing coordinate */
  #along(k, place, draw) {
    const along = /** @type {import("../../../view/map/types.js").Axis} */ (this.facts.axes[k]);
    const value = shown(Number(this.axes[k]?.[place]), along);
    return draw(value, span(along.low, along.high, 1));
  }

  /** @param {MouseEvent} event @returns {number[]} the point of the grid under the pointer */
  #placesAt(event) {
    const box = this.over.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * g.WIDTH;
    const y = ((event.clientY - box.top) / box.height) * this.height;
    const fractions = [(x - g.LEFT) / (g.RIGHT - g.LEFT), (g.BOTTOM - y) / (g.BOTTOM - g.TOP)];
    return this.axes.map(({ length }, k) => {
      const place = Math.round(Number(fractions[k]) * (length - 1));
      return Math.min(length - 1, Math.max(0, place));
    });
  }
}
