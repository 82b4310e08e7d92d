/** The model set by hand: a slider and a number for each of its quantities, bound together. */

import { tr } from "../../../view/language.js";
import { need } from "../shared/dom.js";
import { complain, ifTyped, numberIn, unlessPositive } from "../shared/number-box.js";
import { outside } from "../shared/typed.js";

/** @typedef {import("../../../view/measured/types.js").Hand} Hand */
/** @typedef {import("../../../view/measured/types.js").Track} Track */
/** @typedef {{key: string, slide: HTMLInputElement, box: HTMLInputElement, label: HTMLElement}} Row */

const FASTER = 1.5; // times the fastest the film shows
const RATIO = [0.1, 10];
/** Of what Python would set to an end (sim/bridge/measured_answer.py), or what no carts have. @type {Record<string, [number, number]>} */
const LIMITS = { e: [0, 1], ratio: [0.001, 1000] };
const LONGEST = 0.4; // s, of a contact

export class Hands {
  /** @param {HTMLElement} root @param {() => void} changed */
  constructor(root, changed) {
    /** @type {Map<string, Row>} */
    this.rows = new Map();
    for (const place of root.querySelectorAll(".carts-measured-hand")) {
      const slide = /** @type {HTMLInputElement} */ (need(place, "input[type=range]"));
      const box = /** @type {HTMLInputElement} */ (need(place, "input[type=text]"));
      const key = /** @type {HTMLElement} */ (place).dataset.hand ?? "";
      const row = { key, slide, box, label: need(place, "label") };
      this.rows.set(key, row);
      slide.addEventListener("input", () => {
        put(row, slide.valueAsNumber);
        changed();
      });
      box.addEventListener("change", () => {
        complain(box, problem(row));
        if (!box.value.trim()) put(row, slide.valueAsNumber);
        const value = taken(row);
        if (value === null) return; // it stands there to be mended
        slide.value = String(value);
        changed();
      });
    }
  }

  /** What the sliders may be set to, from the readings. @param {Track[]} tracks @param {string[]} names */
  reach(tracks, names) {
    const times = tracks.flatMap((track) => track.t);
    const [begin, end] = [Math.min(...times), Math.max(...times)];
    const speeds = tracks.map((track) => fastest(track));
    const most = FASTER * Math.max(...speeds, 1e-3);
    const [a = "A", b = "B"] = names;
    this.#set("touch", begin, end);
    this.#set("va", -most, most, tr("velocity of {cart} before", { cart: a }));
    this.#set("vb", -most, most, tr("velocity of {cart} before", { cart: b }));
    this.#set(
      "ratio",
      Number(RATIO[0]),
      Number(RATIO[1]),
      tr("mass of {b} ÷ mass of {a}", { a, b }),
    );
    this.#set("e", 0, 1);
    this.#set("duration", 0.001, Math.min(LONGEST, (end - begin) / 2));
  }

  /** @param {string} key @param {number} low @param {number} high @param {string} label */
  #set(key, low, high, label = "") {
    const row = this.rows.get(key);
    if (!row) return;
    for (const input of [row.slide, row.box]) input.disabled = false;
    const step = 10 ** Math.floor(Math.log10((high - low) / 400));
    Object.assign(row.slide, { min: low, max: high, step });
    if (label) {
      row.slide.setAttribute("aria-label", label);
      row.label.textContent = label;
    }
  }

  /** @param {Hand} hand */
  set value(hand) {
    const values = { ...hand, va: hand.v[0], vb: hand.v[1] };
    for (const [key, row] of this.rows) {
      const value = Number(values[/** @type {keyof typeof values} */ (key)]);
      row.slide.value = String(value);
      put(row, value);
    }
  }

  /** @returns {Hand} */
  get value() {
    const read = (/** @type {string} */ key) => {
      const row = this.rows.get(key);
      return row ? (taken(row) ?? row.slide.valueAsNumber) : 0;
    };
    return {
      touch: read("touch"),
      x: 0,
      distance: 0,
      v: [read("va"), read("vb")],
      ratio: read("ratio"),
      e: read("e"),
      duration: read("duration"),
    };
  }
}

/** Why Python would not take what stands in a box; empty: it does, or the box is. @param {Row} row */
function problem({ key, box, label }) {
  if (key === "duration") return unlessPositive(box, ifTyped(box)); // of a contact that never ends it is a billion
  const [low, high] = LIMITS[key] ?? [-Infinity, Infinity];
  const value = numberIn(box);
  if (value === null || (value >= low && value <= high)) return ifTyped(box);
  return outside({ label: label.textContent ?? "", unit: "" }, String(low), String(high));
}

/** @param {Row} row @returns {number | null} */
const taken = (row) => (problem(row) ? null : numberIn(row.box));

/** Four figures, but none that its slider could not tell, with a minus as in the tables. @param {Pick<Row, "box" | "slide">} row @param {number} value */
function put({ box, slide }, value) {
  const finest = (Number(slide.step) || 0.001) / 100;
  const figures = Number(value.toPrecision(4));
  const decimals = Math.max(0, Math.round(-Math.log10(finest)));
  box.value = String(Number(figures.toFixed(decimals))).replace(/^-/, "−");
  complain(box, "");
}

/** m/s over a fifth of the film, so that noise does not count. @param {Track} track */
function fastest({ t, value }) {
  const apart = Math.max(1, Math.floor(t.length / 5));
  let found = 0;
  for (let k = apart; k < t.length; k += 1) {
    const speed =
      (Number(value[k]) - Number(value[k - apart])) / (Number(t[k]) - Number(t[k - apart]));
    found = Math.max(found, Math.abs(speed));
  }
  return found;
}
