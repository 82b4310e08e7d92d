/**
 * Runs that were computed when the page was made (`sim/pages/prepared`). Where Python cannot start,
 * or has not yet, the sliders go by them: from one to the next, each as exact as any other run.
 */

import { tr } from "../../../view/language.js";
import { gunzip, loadPart } from "../runtime/payload.js";
import { asText } from "../shared/settings.js";
import { nearest } from "./controls.js";

/** @typedef {import("./values.js").Settings} Settings */
/** @typedef {{set: string, values: (number | string | boolean)[], numbers: number[]}} Axis `values` as the page asks for them, `numbers` the same in SI */
/** @typedef {{axes: Axis[], presets: Settings[], headers: any[], numbers: Float64Array}} Table */
/** @typedef {{header: any, numbers: Float64Array, set: Settings}} Found */

const TEXT_AT = 8; // bytes: before it stands its length

export class Prepared {
  /** @type {Promise<Table> | null} */
  #loading = null;

  /**
   * @param {HTMLElement} scene @param {import("../../../view/types.js").Fence} fence
   * @param {string} folder address of the scripts, with a slash at its end
   */
  constructor(scene, { controls, switches = [] }, folder) {
    const { parts = [], stops = {} } = JSON.parse(scene.dataset.prepared ?? "{}");
    /** @type {import("../runtime/payload.js").Part[]} */
    this.parts = parts;
    /** @type {Record<string, number[]>} the values of each slider, in its own unit, by its target */
    this.stops = stops;
    this.name = scene.id;
    this.controls = controls;
    this.switches = switches;
    this.folder = folder;
  }

  /** Whether there are any that this browser can read. */
  get there() {
    return this.parts.length > 0 && typeof DecompressionStream === "function";
  }

  /**
   * The prepared run whose values are nearest. Rejects with a sentence for the reader where the
   * change is of another kind, and where the runs cannot be loaded.
   * @param {Settings} wanted @returns {Promise<Found>}
   */
  async nearest(wanted) {
    this.#loading ??= this.#load().catch((error) => {
      this.#loading = null; // the next move of a slider asks again
      throw error;
    });
    const table = await this.#loading;
    const place = presetOf(table, wanted) ?? this.#onGrid(table, wanted);
    return { ...runAt(table, place.number), set: place.set };
  }

  /** @param {Table} table @param {Settings} wanted */
  #onGrid({ axes, presets }, wanted) {
    const others = Object.keys(wanted).filter((key) => !axes.some((axis) => axis.set === key));
    if (others.length) {
      const ready = presets.some((one) => others.every((key) => one[key] === wanted[key]));
      throw new Error(
        ready
          ? tr("Ready-made values can be changed with Python only. Press: Reset all values.")
          : tr("This change needs Python, which does not run here."),
      );
    }
    /** @type {Settings} */
    const set = {};
    let number = 0;
    for (const axis of axes) {
      const asked = wanted[axis.set];
      const place = nearest(axis.numbers, this.#number(axis, asked));
      number = number * axis.values.length + place;
      if (asked !== undefined) set[axis.set] = axis.values[place] ?? asked;
    }
    return { number, set };
  }

  /** @param {Axis} axis @param {number | string | boolean | undefined} asked @returns {number} SI */
  #number(axis, asked) {
    const control = this.controls.find(({ set }) => set === axis.set);
    const box = this.switches.find(({ set }) => set === axis.set);
    if (asked === undefined) return control ? control.value * control.per : Number(box?.value);
    if (typeof asked !== "string") return Number(asked);
    const text = asked.trim();
    const unit = control?.unit ?? "";
    const number = text.endsWith(unit) ? text.slice(0, text.length - unit.length) : "";
    if (!control || number.trim() === "" || Number.isNaN(Number(number))) {
      throw new Error(tr("A number without a unit, please: Python does not run here."));
    }
    return Number(number) * control.per;
  }

  /** @returns {Promise<Table>} */
  async #load() {
    const parts = await Promise.all(
      this.parts.map((part, k) => loadPart(this.folder, this.name, k, part)),
    );
    const bytes = await gunzip(parts);
    const length = new DataView(bytes).getUint32(0, true);
    const text = new TextDecoder().decode(new Uint8Array(bytes, TEXT_AT, length));
    return { ...JSON.parse(text), numbers: new Float64Array(bytes, TEXT_AT + length) };
  }
}

/** A button sets several values at once, others than the sliders too. @param {Table} table @param {Settings} wanted */
function presetOf({ axes, presets }, wanted) {
  const k = presets.findIndex((preset) => asText(preset) === asText(wanted));
  if (k < 0) return null;
  const before = axes.reduce((product, axis) => product * axis.values.length, 1);
  return { number: before + k, set: wanted };
}

/** @param {Table} table @param {number} place */
function runAt({ headers, numbers }, place) {
  const sizeOf = (/** @type {any} */ header) =>
    header.ok ? header.rows * header.columns.length : 0;
  const start = headers.slice(0, place).reduce((sum, header) => sum + sizeOf(header), 0);
  const header = headers[place];
  return { header, numbers: numbers.subarray(start, start + sizeOf(header)) };
}
