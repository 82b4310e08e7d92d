/** Sliders and their number boxes. A wrong value is explained beside the box; the picture stays. */

import { decimalsOf, fixed } from "../../../view/numbers.js";
import { need, put, say } from "../shared/dom.js";
import { onEnter } from "../shared/enter.js";
import { outside, readTyped } from "../shared/typed.js";
import { effectValue, Switches } from "./switches.js";

/** @typedef {import("../../../view/types.js").Control} Control */
/** @typedef {(target: string, value: any, at: number) => void} Change `value`: SI number, text with a unit, or whether an effect acts; `at`: time of the input */
/** @typedef {(target: string) => number[] | undefined} Stops the only values that a slider can take now, in its unit, if there are such */

const KEYS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 3, PageDown: -3 };

export class Controls {
  /** @type {Map<string, ControlView>} */
  #views = new Map();
  on = false; // values may be changed, here or in the picture

  /** @param {HTMLElement} root @param {Control[]} controls @param {{change: Change, stops?: Stops}} acts @param {import("../../../view/types.js").Fence["switches"]} switches */
  constructor(root, controls, { change, stops = () => undefined }, switches = []) {
    this.switches = new Switches(root, switches, change);
    for (const control of controls) {
      const element = /** @type {HTMLElement | null} */ (
        root.querySelector(`.carts-control[data-set="${CSS.escape(control.set)}"]`)
      );
      if (element) this.#views.set(control.set, new ControlView(element, control, change, stops));
    }
  }

  /** @param {boolean} on */
  enable(on) {
    this.on = on;
    for (const view of this.#views.values()) view.enable(on);
    this.switches.enable(on);
  }

  /**
   * Shows the values of the run on screen. A slider that has gone on since stays where it is: its next
   * step by a key is one from there.
   * @param {Record<string, unknown>} settings @param {import("../../../view/types.js").Header} header @param {Set<string>} pending
   */
  show(settings, header, pending) {
    this.switches.show(header, pending);
    for (const [target, view] of this.#views) {
      if (pending.has(target)) continue;
      const value = target in settings ? settings[target] : view.control.value;
      const number = valueIn(header, target) ?? Number(value) * view.control.per;
      if (Number.isFinite(number)) view.show(view.shown(number));
      else if (!(target in settings)) view.show(view.control.value);
    }
  }

  /** A value from elsewhere than its slider. @param {string} target @param {number} value in the control's unit @param {number} at */
  take(target, value, at) {
    this.#views.get(target)?.take(value, at);
  }

  /** @param {string} target @param {string} message @returns {boolean} whether there is such a control */
  complain(target, message) {
    this.#views.get(target)?.complain(message);
    return this.#views.has(target) || this.switches.complain(target, message);
  }
}

class ControlView {
  #sent = ""; // the text in the box that a run was asked for with

  /** @param {HTMLElement} root @param {Control} control @param {Change} change @param {Stops} stops */
  constructor(root, control, change, stops) {
    this.root = root;
    this.control = control;
    this.slider = /** @type {HTMLInputElement} */ (need(root, ".carts-slider"));
    this.box = /** @type {HTMLInputElement} */ (need(root, ".carts-number-box"));
    this.error = need(root, ".carts-error");
    this.decimals = Math.max(
      ...[control.step, control.low, control.value].map((v) => decimalsOf(v)),
    );
    this.change = change;
    this.slider.addEventListener("input", (event) => {
      const to = this.slider.valueAsNumber;
      const values = stops(control.set);
      this.take(values?.[nearest(values, to)] ?? to, event.timeStamp);
    });
    this.slider.addEventListener("keydown", (event) => {
      const by = KEYS[/** @type {keyof typeof KEYS} */ (event.key)];
      const values = stops(control.set);
      if (!by || !values) return;
      event.preventDefault(); // a step of its own could be too small to reach the next value
      const to = nearest(values, this.slider.valueAsNumber) + by;
      this.take(values[Math.max(0, Math.min(to, values.length - 1))] ?? 0, event.timeStamp);
    });
    const typed = () => this.#typed();
    this.box.addEventListener("change", typed);
    onEnter(this.box, typed);
  }

  /** @param {boolean} on */
  enable(on) {
    this.slider.disabled = !on;
    this.box.disabled = !on;
  }

  /** @param {number} value in the control's unit @param {number} at */
  take(value, at) {
    this.#accept(value);
    this.change(this.control.set, this.#asked(value), at);
  }

  /** @param {number} value SI @returns {number} in the control's unit, without the conversion's rounding */
  shown(value) {
    return Number((value / this.control.per).toPrecision(12));
  }

  /** @param {number} value in the control's unit @returns {number | string} what to ask for: SI, or text with the unit */
  #asked(value) {
    return this.control.per === 1 ? value : `${value} ${this.control.unit}`;
  }

  /** @param {number} value in the control's unit; leaves alone what the reader has typed since, and what was said of it */
  show(value) {
    this.slider.valueAsNumber = value;
    put(this.slider, "aria-valuetext", `${this.#text(value)} ${this.control.unit}`);
    const typing = document.activeElement === this.box && this.box.value !== this.#sent;
    if (typing) return;
    this.#write(value);
    this.clear();
  }

  /** @param {string} message */
  complain(message) {
    this.#sent = ""; // what was refused stays in the box to be mended
    say(this.error, message);
    this.error.hidden = false;
    this.root.classList.add("carts-wrong");
    this.box.setAttribute("aria-invalid", "true");
  }

  clear() {
    this.error.hidden = true;
    this.root.classList.remove("carts-wrong");
    this.box.removeAttribute("aria-invalid");
  }

  #typed() {
    if (this.box.value === this.#sent) return; // of Enter and the change that follows it, one asks
    const at = performance.now();
    const { low, high, unit } = this.control;
    const read = readTyped(withoutUnit(this.box.value, unit));
    if ("problem" in read) return this.complain(read.problem);
    if ("text" in read) {
      this.#sent = this.box.value;
      return this.change(this.control.set, read.text, at);
    }
    if (read.value < low || read.value > high)
      return this.complain(outside(this.control, this.#text(low), this.#text(high)));
    return this.take(read.value, at);
  }

  /** @param {number} value */
  #accept(value) {
    this.slider.valueAsNumber = value;
    put(this.slider, "aria-valuetext", `${this.#text(value)} ${this.control.unit}`);
    this.#write(value);
    this.clear();
  }

  /** @param {number} value */
  #write(value) {
    const text = this.#text(value).replace("−", "-");
    this.#sent = text;
    if (this.box.value !== text) this.box.value = text;
  }

  /** @param {number} value */
  #text(value) {
    return fixed(value, Math.max(this.decimals, decimalsOf(value)));
  }
}

/** A number with the box's own unit behind it is that number; any other unit is Python's to read. @param {string} typed @param {string} unit */
function withoutUnit(typed, unit) {
  const text = typed.trim();
  const number = text.slice(0, text.length - unit.length);
  return unit && text.endsWith(unit) && /[\d.,\s]$/.test(number) ? number : text; // not of mm/s
}

/** @param {number[]} values @param {number} asked @returns {number} place of the nearest; of two alike the lower */
export function nearest(values, asked) {
  const far = (/** @type {number} */ x) => Math.abs(x - asked);
  return values.reduce((best, x, k) => (far(x) < far(values[best] ?? 0) ? k : best), 0);
}

/** What a run says about a control's target; null where the header has no such number. */
/** @param {import("../../../view/types.js").Header} header @param {string} target @returns {number | null} */
export function valueIn(header, target) {
  const [owner, key] = target.split(".");
  const body = header.bodies.find(({ name }) => name === owner);
  if (body) return Number(/** @type {any} */ (body)[String(key)]);
  if (target === "until" || target === "gravity") return header[target];
  if (target === "track.length") return header.track.length;
  if (owner === "contact" && (key === "restitution" || key === "stiffness")) {
    const values = new Set(header.contacts.map((contact) => contact[key]));
    return values.size === 1 ? ([...values][0] ?? null) : null;
  }
  return effectValue(header, target);
}
