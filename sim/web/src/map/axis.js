/** Slider and number box of one axis of a map: they choose a point of the grid. */

import { tr } from "../../../view/language.js";
import { axisDecimals, shown } from "../../../view/map/words.js";
import { fixed } from "../../../view/numbers.js";
import { need, put, say } from "../shared/dom.js";
import { onEnter } from "../shared/enter.js";
import { noNumber, outside, readTyped } from "../shared/typed.js";

/** @typedef {import("../../../view/map/types.js").Axis} Axis */

export class AxisControl {
  #read = ""; // the text in the box that was taken, or shown

  /** @param {HTMLElement} root @param {Axis} axis @param {(place: number) => void} chosen */
  constructor(root, axis, chosen) {
    this.root = root;
    this.axis = axis;
    this.values = axis.values;
    this.decimals = axisDecimals(axis);
    this.slider = /** @type {HTMLInputElement} */ (need(root, ".carts-slider"));
    this.box = /** @type {HTMLInputElement} */ (need(root, ".carts-number-box"));
    this.error = need(root, ".carts-error");
    this.slider.addEventListener("input", () => chosen(this.slider.valueAsNumber));
    const typed = () => this.#typed(chosen);
    this.box.addEventListener("change", typed);
    onEnter(this.box, typed);
  }

  /** @param {boolean} on */
  enable(on) {
    this.slider.disabled = !on;
    this.box.disabled = !on;
  }

  /** @param {number[]} values of the grid, SI @param {number} place */
  show(values, place) {
    this.values = values;
    put(this.slider, "max", String(values.length - 1));
    this.slider.valueAsNumber = place;
    if (document.activeElement === this.box && this.box.value !== this.#read) return; // being typed
    this.#read = this.text(place).replace("−", "-");
    this.box.value = this.#read;
    this.#complain("");
  }

  /** What a screen reader says at the slider: the point and its value. @param {number} place @param {string} value */
  speak(place, value) {
    put(this.slider, "aria-valuetext", `${this.text(place)} ${this.axis.unit}: ${value}`);
  }

  /** @param {number} place @returns {string} in the axis's unit */
  text(place) {
    return fixed(shown(Number(this.values[place]), this.axis), this.decimals);
  }

  /** @param {number} value SI, or in the axis's unit @returns {number} the nearest point */
  nearest(value, per = 1) {
    let best = 0;
    for (const [k, at] of this.values.entries()) {
      if (Math.abs(at / per - value) < Math.abs(Number(this.values[best]) / per - value)) best = k;
    }
    return best;
  }

  /** @param {(place: number) => void} chosen */
  #typed(chosen) {
    if (this.box.value === this.#read) return; // of Enter and the change that follows it, one asks
    this.#read = this.box.value;
    const { low, high, unit, label, per } = this.axis;
    const { decimals } = this;
    const read = readTyped(this.box.value);
    if ("problem" in read) return this.#complain(read.problem);
    if ("text" in read) {
      const wanted = tr("{label}: a number in {unit}, please.", { label, unit });
      return this.#complain(unit ? wanted : noNumber(read.text));
    }
    if (read.value < low || read.value > high)
      return this.#complain(outside(this.axis, fixed(low, decimals), fixed(high, decimals)));
    return chosen(this.nearest(read.value, per));
  }

  /** @param {string} message */
  #complain(message) {
    say(this.error, message);
    this.error.hidden = !message;
    this.root.classList.toggle("carts-wrong", Boolean(message));
    if (message) this.box.setAttribute("aria-invalid", "true");
    else this.box.removeAttribute("aria-invalid");
  }
}
