/**
 * The ledger where effects act: Python counts it when a reader opens it, also within a flight.
 * Who shows the graph asks by an event; the scene's element answers it.
 */

import { listed } from "./bodies.js";
import { viewOf } from "./effects.js";
import { tr } from "./language.js";
import { styleOf } from "./markers.js";

/** @typedef {import("./series.js").Series} Series */
/** @typedef {{names: string[], t: Float64Array, columns: Float64Array[], moving: Float64Array[]}} Parts J, by part and by cart, at t s */

export const WANTED = "carts-energy-wanted";

const [BUMPERS, WARMED] = ["bumpers", "warmed"]; // parts that are no effect's
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
 * @param {import("./types.js").Header} header @param {Parts} parts @returns {Series[]}
 */
export function ledgerWithEffects(header, parts) {
  const column = (/** @type {string} */ name) =>
    parts.columns[parts.names.indexOf(name)] ?? new Float64Array(parts.t.length);
  /** @type {Series[]} */
  const bands = parts.moving.map((values, i) => ({
    label: tr("motion of {cart}", { cart: header.bodies[i]?.name ?? "" }),
    style: styleOf(i),
    over: false,
    values,
    slopes: null,
  }));
  for (const name of parts.names.filter((one) => one !== WARMED)) {
    const [label, style] =
      name === BUMPERS ? [tr("in squeezed bumpers"), "squeezed"] : [stored(name, header), "stored"];
    if (!label) continue; // it gives energy, or takes it away, and keeps none
    const values = column(name);
    // What is stored counts from where there is least. (A long run has more values than a call takes.)
    const lowest = values.reduce((least, value) => Math.min(least, value), 0);
    const above = Float64Array.from(values, (value) => value - lowest);
    bands.push({ label, style, over: false, values: above, slopes: null });
  }
  const warm = { values: column(WARMED), style: "warmed", over: false, slopes: null };
  bands.push({ ...warm, label: warmed(header) });
  return bands;
}

/** @param {string} kind @param {import("./types.js").Header} header @returns {string} where effects of that kind store energy; "" where they do not */
function stored(kind, { effects }) {
  const { lasts, stored: where = "" } = viewOf(kind);
  return !lasts || effects.some((one) => one.kind === kind && lasts(one)) ? where : "";
}

/** @param {import("./types.js").Header} header */
function warmed({ contacts, effects }) {
  const what = contacts.length ? [tr("bumpers")] : [];
  for (const effect of effects.filter(({ active }) => active)) {
    what.push(viewOf(effect.kind).warms?.(effect) ?? "");
  }
  const names = [...new Set(what.filter(Boolean))];
  const things = listed(names) || AROUND;
  return tr("has warmed the {things}", { things });
}
