/** Prediction: how a force changes during the contact, a velocity or a position during the run. */

import { body } from "../../../view/bodies.js";
import { tr } from "../../../view/language.js";
import { fixed } from "../../../view/numbers.js";
import { HIGHEST, LEFT, POINTS, pad, path, STEP } from "../../../view/pad.js";
import { valueAt } from "../../../view/trajectory.js";
import { touches } from "../../../view/windows.js";
import { html, need, put } from "../shared/dom.js";
import { complain, numberIn, problemIn } from "../shared/number-box.js";
import { outside } from "../shared/typed.js";
import { features } from "./curve-features.js";
import { placeLabels } from "./pad-labels.js";

const FINE = 48; // pieces of the run's own curve: a multiple of four

export class CurveForm {
  /** @type {(number | null)[]} */
  #heights = Array(POINTS).fill(null);
  #enabled = false;
  /** @type {number[][]} heights of the run's own curve, when it is shown */
  #seen = [];

  /** @param {HTMLElement} root @param {import("../../../view/types.js").PredictSpec} spec @param {() => void} changed */
  constructor(root, spec, changed) {
    this.cart = spec.cart ?? "";
    this.quantity = spec.quantity;
    this.place = pad(spec.quantity);
    this.changed = changed;
    this.pad = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (need(root, ".carts-pad")));
    this.boxes = /** @type {HTMLInputElement[]} */ ([...root.querySelectorAll(".carts-height")]);
    this.boxes.forEach((box, k) => {
      box.addEventListener("input", () => this.#set(k, this.#beyond(box) ? null : numberIn(box)));
      box.addEventListener("change", () => {
        const beyond = this.#beyond(box);
        complain(box, beyond || problemIn(box));
        if (!beyond) this.#show(k);
      });
    });
    this.pad.addEventListener("pointerdown", (event) => {
      if (!this.#enabled || event.button > 0) return;
      this.pad.setPointerCapture(event.pointerId);
      this.#point(event);
    });
    this.pad.addEventListener("pointermove", (event) => {
      if (this.#enabled && event.buttons & 1) this.#point(event);
    });
  }

  get value() {
    return [...this.#heights]; // what was said before stays when the curve is drawn on
  }

  /** @returns {string} */
  get said() {
    return tr("heights {heights}", {
      heights: this.#heights.map((height) => height ?? "–").join(", "),
    });
  }

  set value(value) {
    if (Array.isArray(value) && value.length === this.#heights.length) this.#heights = [...value];
    this.boxes.forEach((_, k) => {
      this.#show(k);
    });
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
    const seen = this.quantity === "F" ? this.#force(run) : this.#motion(run);
    if (!seen)
      return [html("p", "", tr("In this run nothing touches {cart}.", { cart: this.cart }))];
    const top = Math.max(...seen.values.map(Math.abs)) || 1;
    const scaled = seen.values.map((value) => (HIGHEST * value) / top);
    put(need(this.pad, '[data-part="answer"]'), "d", path(this.place, scaled));
    this.#seen = [scaled];
    this.#draw();
    const list = html("ul");
    for (const [feature, yours, theirs] of features(
      this.quantity,
      this.#heights.map(Number),
      scaled,
    )) {
      if (!yours && !theirs) continue; // nothing to see in either
      const said = (/** @type {boolean} */ yes) => (yes ? tr("yes") : tr("no"));
      const both = { feature, yours: said(yours), theirs: said(theirs) };
      list.append(html("li", "", tr("{feature}: your curve {yours}, the run {theirs}", both)));
    }
    return [html("p", "", seen.title), list];
  }

  /** The force during the first contact. @param {import("../../../view/types.js").Run} run */
  #force({ header, trajectory: { t, F, dF } }) {
    const touch = touches(header.events, header.until).find(({ bodies }) =>
      bodies.includes(this.cart),
    );
    if (!touch) return null;
    const values = evenly(touch.start, touch.end, (at) =>
      valueAt(t, F[touch.pair] ?? [0], dF[touch.pair] ?? [0], at),
    );
    const other = touch.bodies.find((name) => name !== this.cart) ?? "";
    const title = tr(
      "Force on {cart} by {other}: dashed is yours, solid is the run. Only the shape counts.",
      { cart: this.cart, other: body(other, header.track) },
    );
    return { values, title };
  }

  /** Velocity, or the way from the start, during the whole run. @param {import("../../../view/types.js").Run} run */
  #motion({ header, trajectory: { t, x, v, a } }) {
    const [values, slopes] = this.quantity === "v" ? [v, a] : [x, v];
    const start = this.quantity === "v" ? 0 : Number(values[this.cart]?.[0]);
    const title =
      this.quantity === "v"
        ? tr("Velocity of {cart}: dashed is yours, solid is the run. Only the shape counts.", {
            cart: this.cart,
          })
        : tr(
            "Displacement of {cart} from the start: dashed is yours, solid is the run. Only the shape counts.",
            {
              cart: this.cart,
            },
          );
    const at = (/** @type {number} */ time) =>
      valueAt(t, values[this.cart] ?? [0], slopes[this.cart] ?? [0], time) - start;
    return { values: evenly(0, header.until, at), title };
  }

  /** Why the height in a box is none for this pad; empty: it is one, or cannot be read. @param {HTMLInputElement} box */
  #beyond(box) {
    const height = numberIn(box) ?? 0;
    if (height >= this.place.low && height <= HIGHEST) return "";
    const label = box.closest("label")?.firstChild?.textContent?.trim() ?? "";
    return outside({ label, unit: "" }, fixed(this.place.low, 0), fixed(HIGHEST, 0));
  }

  /** @param {PointerEvent} event */
  #point(event) {
    const frame = this.pad.getBoundingClientRect();
    const scale = 360 / frame.width;
    const k = Math.round(((event.clientX - frame.left) * scale - LEFT) / STEP);
    const height = (this.place.zero - (event.clientY - frame.top) * scale) / this.place.per;
    if (k >= 0 && k < this.#heights.length) {
      this.#set(k, Math.round(2 * height) / 2);
      this.#show(k);
    }
  }

  /** @param {number} k @param {number | null} height null: none, or none that can be read */
  #set(k, height) {
    this.#heights[k] = height === null ? null : Math.min(HIGHEST, Math.max(this.place.low, height));
    this.#draw();
    this.changed();
  }

  /** The box says the height; what cannot be read stays there to be mended. @param {number} k */
  #show(k) {
    const [box, height] = [this.boxes[k], this.#heights[k] ?? null];
    if (!box || numberIn(box) === height) return;
    box.value = String(height ?? "");
    complain(box, "");
  }

  #draw() {
    this.#heights.forEach((height, k) => {
      const knob = this.pad.querySelector(`[data-index="${k}"]`);
      if (knob) put(knob, "cy", String(this.place.zero - this.place.per * (height ?? 0)));
    });
    const drawn = this.#heights.map((height) => height ?? 0);
    put(need(this.pad, '[data-part="sketch"]'), "d", path(this.place, drawn));
    placeLabels(this.pad, [drawn, ...this.#seen]);
  }
}

/** @param {number} from @param {number} to @param {(t: number) => number} value @returns {number[]} */
function evenly(from, to, value) {
  return Array.from({ length: FINE + 1 }, (_, k) => value(from + ((to - from) * k) / FINE));
}
