/**
 * The ledger where effects act: motion is in the run, all else Python counts when a reader opens it.
 * Who shows the graph asks by an event; the scene's element answers it.
 */

import { tr } from "./language.js";
import { listed } from "./listed.js";
import { seriesOf } from "./series.js";
import { valueAt } from "./trajectory.js";

/** @typedef {import("./types.js").Run} Run */
/** @typedef {import("./series.js").Series} Series */
/** @typedef {{names: string[], t: Float64Array, columns: Float64Array[]}} Parts J, column after column */

export const WANTED = "carts-energy-wanted";

/** @type {Record<string, [string, string]>} what a band is called, and its style */
const BANDS = {
  bumpers: [tr("in squeezed bumpers"), "squeezed"],
  spring: [tr("in the spring"), "stored"],
  magnets: [tr("between the magnets"), "stored"],
  incline: [tr("as height, above the lowest point"), "stored"],
};
/** @type {Record<string, string>} what friction, drag and dampers warm */
const WARM = { friction: tr("track"), drag: tr("air"), spring: tr("spring") };

const AROUND = tr("surroundings");

/** @param {import("./types.js").Baked} baked @returns {boolean} whether the ledger needs what Python counts */
export function needsParts({ fence }) {
  return /** @type {unknown[]} */ (fence.scene.effects ?? []).length > 0;
}

/** @param {Element} root of the graph @returns {Promise<Parts | null>} null where Python cannot answer now */
export function askParts(root) {
  return new Promise((resolve) => {
    const detail = { answer: resolve, heard: false };
    root.dispatchEvent(new CustomEvent(WANTED, { bubbles: true, detail }));
    if (!detail.heard) resolve(null);
  });
}

/**
 * Bands from below to above; their sum is the energy at the start with what was given since.
 * @param {Run} run @param {Parts} parts @returns {Series[]}
 */
export function ledgerWithEffects({ header, trajectory }, parts) {
  const times = trajectory.t;
  const moving = seriesOf("energy", header, trajectory, 0).filter((c) => c.style !== "total");
  const column = (/** @type {string} */ name) => {
    const values = parts.columns[parts.names.indexOf(name)] ?? new Float64Array(times.length);
    if (values.length === times.length) return values;
    return Float64Array.from(times, (t) => valueAt(parts.t, values, null, Number(t)));
  };
  /** @type {Series[]} */
  const bands = moving.map((curve) => ({
    ...curve,
    label: tr("motion of {cart}", { cart: curve.label }),
  }));
  for (const [name, [label, style]] of Object.entries(BANDS)) {
    if (!parts.names.includes(name)) continue;
    const values = column(name);
    // What is stored counts from where there is least. (A long run has more values than a call takes.)
    const lowest = values.reduce((least, value) => Math.min(least, value), 0);
    const above = Float64Array.from(values, (value) => value - lowest);
    bands.push({ label, style, over: false, values: above, slopes: null });
  }
  const warm = Float64Array.from(column("warmed"), (value) => Math.max(0, value));
  bands.push({ label: warmed(header), style: "warmed", over: false, values: warm, slopes: null });
  return bands;
}

/** @param {import("./types.js").Header} header */
function warmed({ contacts, effects }) {
  const what = contacts.length ? [tr("bumpers")] : [];
  for (const { kind, active, numbers } of effects) {
    const damped = kind !== "spring" || (numbers.damping ?? 0) > 0;
    if (active && WARM[kind] && damped) what.push(String(WARM[kind]));
  }
  const names = [...new Set(what)];
  const things = listed(names) || AROUND;
  return tr("has warmed the {things}", { things });
}
