/** The figure of a map: canvas or curve, and the cross that marks a point. */

import { px } from "../../../view/numbers.js";
import { span } from "../../../view/scales.js";
import { html, need, put } from "../shared/dom.js";
import { paint } from "./paint.js";

/** @typedef {import("./types.js").MapFacts} MapFacts */
/** @typedef {import("./types.js").Grid} Grid */

export class MapFigure {
  /** @type {HTMLCanvasElement | null} */
  #canvas = null;

  /** @param {HTMLElement} root @param {MapFacts} facts @param {(places: number[]) => void} point */
  constructor(root, facts, point) {
    this.facts = facts;
    this.holder = need(root, ".carts-map-figure");
    /** @type {SVGElement} */
    this.over = need(root, ".carts-map-over");
    /** @type {number[][]} */
    this.axes = facts.axes.map(({ values }) => values);
    const pointed = (/** @type {PointerEvent} */ event) => point(this.#placesAt(event));
    this.over.addEventListener("pointerdown", (event) => {
      if (!this.#canvas && facts.axes.length === 2) return;
      this.over.setPointerCapture(event.pointerId);
      pointed(event);
    });
    this.over.addEventListener("pointermove", (event) => {
      if (event.buttons && this.over.hasPointerCapture(event.pointerId)) pointed(event);
    });
  }

  /** @param {Grid} grid */
  show(grid) {
    this.axes = grid.axes;
    if (grid.axes.length === 1) return this.#curve(grid);
    this.#canvas ??= this.#laid();
    paint(this.#canvas, grid, this.facts.scale);
  }

  /** @param {number[]} places @param {number} value */
  mark(places, value) {
    const [left, top, right, bottom] = this.facts.plot;
    const x = this.#x(this.#fraction(0, places[0] ?? 0));
    const flat = places.length === 1;
    const y = flat ? this.#y(value) : bottom - (bottom - top) * this.#fraction(1, places[1] ?? 0);
    const across = flat ? "" : `M${left} ${px(y)}H${right}`;
    put(need(this.over, '[data-part="lines"]'), "d", `M${px(x)} ${top}V${bottom}${across}`);
    const point = need(this.over, '[data-part="point"]');
    put(point, "cx", px(x));
    put(point, "cy", px(Number.isNaN(y) ? bottom : y));
    put(point, "visibility", Number.isNaN(y) ? "hidden" : "visible");
  }

  /** The canvas lies between the picture, which it hides, and the cross. */
  #laid() {
    const canvas = /** @type {HTMLCanvasElement} */ (html("canvas", "carts-map-canvas"));
    canvas.setAttribute("aria-hidden", "true");
    const [left, top, right, bottom] = this.facts.plot;
    const [width, height] = this.facts.size;
    canvas.style.left = `${(100 * left) / width}%`;
    canvas.style.top = `${(100 * top) / height}%`;
    canvas.style.width = `${(100 * (right - left)) / width}%`;
    canvas.style.height = `${(100 * (bottom - top)) / height}%`;
    this.over.before(canvas);
    return canvas;
  }

  /** @param {Grid} grid */
  #curve({ axes, values }) {
    let path = "";
    let pen = "M";
    for (const [k, value] of values.entries()) {
      if (Number.isNaN(value)) pen = "M";
      else {
        path += `${pen}${px(this.#x(this.#fraction(0, k, axes[0])))} ${px(this.#y(value))}`;
        pen = "L";
      }
    }
    put(need(this.over, '[data-part="curve"]'), "d", path);
  }

  /** @param {number} k axis @param {number} place @returns {number} 0 to 1 along the axis */
  #fraction(k, place, values = this.axes[k] ?? [0]) {
    const { per, low, high } = /** @type {import("./types.js").Axis} */ (this.facts.axes[k]);
    const axis = span(low, high, 1);
    const shown = Number((Number(values[place]) / per).toPrecision(12));
    return (shown - axis.low) / (axis.high - axis.low);
  }

  /** @param {number} fraction */
  #x(fraction) {
    const [left, , right] = this.facts.plot;
    return left + fraction * (right - left);
  }

  /** @param {number} value */
  #y(value) {
    const [, top, , bottom] = this.facts.plot;
    const { low, high } = this.facts.value;
    return bottom - (value - low) * ((bottom - top) / (high - low));
  }

  /** @param {PointerEvent} event @returns {number[]} the point of the grid under the pointer */
  #placesAt(event) {
    const box = this.over.getBoundingClientRect();
    const [left, top, right, bottom] = this.facts.plot;
    const [width, height] = this.facts.size;
    const x = ((event.clientX - box.left) / box.width) * width;
    const y = ((event.clientY - box.top) / box.height) * height;
    const fractions = [(x - left) / (right - left), (bottom - y) / (bottom - top)];
    return this.axes.map(({ length }, k) => {
      const place = Math.round(Number(fractions[k]) * (length - 1));
      return Math.min(length - 1, Math.max(0, place));
    });
  }
}
