/**
 * Where the energy is at every row of a run: in the motion of each cart, in squeezed bumpers, and
 * what has warmed the bumpers. Carts that touch keep the difference to the start in their bumpers;
 * what has not come back when all of them are apart has warmed them, as the program's own ledger
 * counts it. So it is when a run ends in a contact, where that ledger still has something in the
 * bumpers then. Holds as long as only contacts act.
 */

import { tr } from "./language.js";
import { seriesOf } from "./series.js";

/** @typedef {import("./types.js").Run} Run */
/** @typedef {import("./series.js").Series} Series */
/** @typedef {{start: number, end: number}} Span */

const HELD = 1e-3; // of what is not in motion at the end; dead bumpers hold less, and lose that too

/** @param {Run} run @param {import("./windows.js").Touch[]} windows @param {number} camera in m/s @returns {Series[]} J, from below to above */
export function ledger({ header, trajectory }, windows, camera) {
  const moving = seriesOf("energy", header, trajectory, camera).filter((c) => c.style !== "total");
  const times = trajectory.t;
  const sum = (/** @type {number} */ k) => moving.reduce((s, c) => s + Number(c.values[k]), 0);
  const start = sum(0);
  const squeezed = new Float64Array(times.length);
  const warmed = new Float64Array(times.length);
  const last = Math.max(0, start - sum(times.length - 1));
  const held = Number(header.energy?.parts.bumpers?.final ?? 0) > HELD * last;
  const groups = together(
    windows.map((touch) => (held && touch.lasts ? { ...touch, end: Infinity } : touch)),
  );
  let kept = 0; // J, warmed before the touches that are on
  for (let k = 0; k < times.length; k += 1) {
    const t = Number(times[k]);
    const away = Math.max(0, start - sum(k));
    const on = groups.some((group) => t >= group.start && t < group.end);
    if (!on) kept = away;
    warmed[k] = Math.min(kept, away);
    squeezed[k] = away - Number(warmed[k]);
  }
  return [
    ...moving.map((curve) => ({ ...curve, label: tr("motion of {cart}", { cart: curve.label }) })),
    {
      label: tr("in squeezed bumpers"),
      style: "squeezed",
      over: false,
      values: squeezed,
      slopes: null,
    },
    {
      label: tr("has warmed the {things}", { things: tr("bumpers") }),
      style: "warmed",
      over: false,
      values: warmed,
      slopes: null,
    },
  ];
}

/** Touches that overlap in time, as one. @param {Span[]} windows @returns {Span[]} */
function together(windows) {
  /** @type {Span[]} */
  const groups = [];
  for (const { start, end } of windows) {
    const last = groups.at(-1);
    if (last && start < last.end) last.end = Math.max(last.end, end);
    else groups.push({ start, end });
  }
  return groups;
}

/** Each entry on top of those before it. @param {Series[]} entries @returns {Series[]} */
export function stacked(entries) {
  let below = new Float64Array(entries[0]?.values.length ?? 0);
  return entries.map((entry) => {
    below = Float64Array.from(below, (value, k) => value + Number(entry.values[k]));
    return { ...entry, values: below };
  });
}
