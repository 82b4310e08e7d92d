/** Prediction: how the force changes during the contact. Compared by features, not by pixels. */

import { body } from "../../../view/bodies.js";
import { tr } from "../../../view/language.js";
import { px } from "../../../view/numbers.js";
import { valueAt } from "../../../view/trajectory.js";
import { touches } from "../../../view/windows.js";
import { html, need, put } from "../shared/dom.js";

const LEFT = 40;
const STEP = 77.5;
const BOTTOM = 130;
const PER_HEIGHT = 12; // units per step of height; the highest is 10
const HIGHEST = 10;
const FINE = 48;

export class CurveForm {
  /** @type {(number | null)[]} */
  #heights = [null, null, null, null, null];
  #enabled = false;

  /** @param {HTMLElement} root @param {import("../../../view/types.js").PredictSpec} spec @param {() => void} changed */
  constructor(root, spec, changed) {
    this.cart = spec.cart ?? "";
    this.changed = changed;
    this.pad = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (need(root, ".carts-pad")));
    this.boxes = /** @type {HTMLInputElement[]} */ ([...root.querySelectorAll(".carts-height")]);
    this.boxes.forEach((box, k) => {
      box.addEventListener("input", () => {
        if (Number.isFinite(box.valueAsNumber)) this.#take(k, box.valueAsNumber);
      });
    });
    this.pad.addEventListener("pointerdown", (event) => {
      if (!this.#enabled) return;
      this.pad.setPointerCapture(event.pointerId);
      this.#point(event);
    });
    this.pad.addEventListener("pointermove", (event) => {
      if (this.#enabled && event.buttons & 1) this.#point(event);
    });
  }

  get value() {
    return this.#heights;
  }

  /** @returns {string} */
  get said() {
    return tr("heights {heights}", {
      heights: this.#heights.map((height) => height ?? "–").join(", "),
    });
  }

  set value(value) {
    if (Array.isArray(value) && value.length === this.#heights.length) this.#heights = value;
    this.#draw();
  }

  /** @param {boolean} on */
  enable(on) {
    this.#enabled = on;
    for (const box of this.boxes) box.disabled = !on;
  }

  problem() {
    if (this.#heights.every((height) => height !== null)) return null;
    return tr("Give all five heights first, also where you think it is 0.");
  }

  /** @param {import("../../../view/types.js").Run} run */
  compare(run) {
    const touch = touches(run.header.events, run.header.until).find(({ bodies }) =>
      bodies.includes(this.cart),
    );
    if (!touch)
      return [html("p", "", tr("In this run nothing touches {cart}.", { cart: this.cart }))];
    const { t, F, dF } = run.trajectory;
    const forces = Array.from({ length: FINE + 1 }, (_, k) => {
      const at = touch.start + ((touch.end - touch.start) * k) / FINE;
      return valueAt(t, F[touch.pair] ?? [0], dF[touch.pair] ?? [0], at);
    });
    const top = Math.max(...forces) || 1;
    const points = forces.map((force, k) => {
      const x = LEFT + (4 * STEP * k) / FINE;
      return `${px(x)} ${px(BOTTOM - (HIGHEST * PER_HEIGHT * force) / top)}`;
    });
    put(need(this.pad, '[data-part="answer"]'), "d", `M${points.join("L")}`);
    const other = touch.bodies.find((name) => name !== this.cart) ?? "";
    const mine = this.#heights.map(Number);
    const rows = [
      [tr("starts from zero"), mine[0] === 0, Number(forces[0]) < 0.02 * top],
      [
        tr("is greatest in between"),
        Math.max(...mine.slice(1, 4)) > Math.max(Number(mine[0]), Number(mine[4])),
        true,
      ],
      [tr("goes up once and down once"), hills(mine) === 1, hills(forces.map(Number)) === 1],
      [tr("is zero again at the end"), mine[4] === 0, Number(forces[FINE]) < 0.02 * top],
    ];
    const list = html("ul");
    for (const [feature, yours, theirs] of rows) {
      const said = (/** @type {unknown} */ yes) => (yes ? tr("yes") : tr("no"));
      const both = { feature: String(feature), yours: said(yours), theirs: said(theirs) };
      list.append(html("li", "", tr("{feature}: your curve {yours}, the run {theirs}", both)));
    }
    const title = tr(
      "Force on {cart} by {other}: dashed is yours, solid is the run. Only the shape counts.",
      { cart: this.cart, other: body(other) },
    );
    return [html("p", "", title), list];
  }

  /** @param {PointerEvent} event */
  #point(event) {
    const frame = this.pad.getBoundingClientRect();
    const scale = 360 / frame.width;
    const k = Math.round(((event.clientX - frame.left) * scale - LEFT) / STEP);
    const height = (BOTTOM - (event.clientY - frame.top) * scale) / PER_HEIGHT;
    if (k >= 0 && k < this.#heights.length) this.#take(k, Math.round(2 * height) / 2);
  }

  /** @param {number} k @param {number} height */
  #take(k, height) {
    this.#heights[k] = Math.min(HIGHEST, Math.max(0, height));
    this.#draw();
    this.changed();
  }

  #draw() {
    const points = this.#heights.map((height, k) => {
      const y = px(BOTTOM - PER_HEIGHT * (height ?? 0));
      const knob = this.pad.querySelector(`[data-index="${k}"]`);
      if (knob) put(knob, "cy", y);
      const box = this.boxes[k];
      if (box && height !== null && box.valueAsNumber !== height) box.valueAsNumber = height;
      return `${px(LEFT + STEP * k)} ${y}`;
    });
    put(need(this.pad, '[data-part="sketch"]'), "d", `M${points.join("L")}`);
  }
}

/** @param {number[]} heights @returns {number} how often they go up and then down */
function hills(heights) {
  let found = 0;
  let rising = false;
  heights.forEach((height, k) => {
    const before = heights[k - 1] ?? 0;
    if (height > before) rising = true;
    if (height < before && rising) {
      found += 1;
      rising = false;
    }
  });
  return found + (rising ? 1 : 0);
}
