/** What acts in a scene, in words. Twin of `sim/pages/widget/effects_words.py`. */

import { agent } from "./effects-forces.js";
import { short } from "./numbers.js";
import { body, EFFECTS } from "./words.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Effect} Effect */

/** @type {Record<string, string>} */
const LEFT_OUT = { ...EFFECTS, release: "exploders" };

/** @param {Header} header @param {boolean} numbers false: they would tell a force @returns {string} in and out of the model */
export function actingSentences(header, numbers) {
  if (!header.effects.length) return "";
  const acting = header.effects
    .filter(({ active }) => active)
    .map((effect) => phrase(effect, header, numbers));
  const inside = acting.length ? acting.join("; ") : "nothing but the contacts between the carts";
  const leftOut = header.notSimulated.map((name) => LEFT_OUT[name] ?? name);
  const outside = leftOut.length ? ` Left out: ${leftOut.join(", ")}.` : "";
  return `In this model: ${inside}.${outside}`;
}

/** @param {Effect} effect @param {Header} header @param {boolean} numbers */
function phrase(effect, header, numbers) {
  const { kind, numbers: n, carts, between } = effect;
  const names = between ?? carts;
  const on = carts.length === header.bodies.length ? "" : ` on ${listed(carts)}`;
  const both = listed(names.map(body));
  const told = (/** @type {string} */ text) => (numbers ? `, ${text}` : "");
  const value = (/** @type {string} */ key) => n[key] ?? 0;
  switch (kind) {
    case "friction": {
      const held = n.static ?? value("coefficient");
      const rest = held > value("coefficient") ? ` (at rest up to ${short(held)})` : "";
      return `friction${on} by the track${told(`μ = ${short(value("coefficient"))}${rest}`)}`;
    }
    case "incline":
      return `a slope${on}, ${slopeText(value("angle"))}`;
    case "drag": {
      const parts = [
        ["linear", "m/s"],
        ["quadratic", "(m/s)²"],
      ]
        .filter(([key]) => value(String(key)))
        .map(([key, unit]) => `${short(value(String(key)))} N per ${unit}`);
      return `drag${on} by the air${told(parts.join(" and ") || "0 N")}`;
    }
    case "push":
      return `a push on ${names[0]} by ${agent(effect)}${told(pushText(value("force")))}${pushTimes(effect)}`;
    case "spring": {
      const damped = n.damping ? ", damped" : "";
      const stiff = `${short(value("stiffness"))} N/m, natural length ${short(value("length"))} m`;
      return `a spring between ${both}${damped}${told(stiff)}`;
    }
    case "magnets":
      return `magnets on ${both}, like poles facing`;
    default:
      return `an exploder between ${both}${told(`${short(value("energy"))} J`)}, at ${short(value("at"))} s`;
  }
}

/** @param {Header} header @returns {string} what the graph of F shows: springs and magnets act without contact */
export function forceName({ effects }) {
  const linked = effects.some(({ kind }) => kind === "spring" || kind === "magnets");
  return linked ? "force between them" : "contact force";
}

/** @param {number} force in N @returns {string} with its direction */
export function pushText(force) {
  return `${short(Math.abs(force))} N to the ${force >= 0 ? "right" : "left"}`;
}

/** When a push lasts; nothing where it always does. @param {Effect} effect */
function pushTimes({ numbers }) {
  const { from = 0, until } = numbers;
  const start = from || until !== undefined ? `, from ${short(from)} s` : "";
  return start + (until === undefined ? "" : ` to ${short(until)} s`);
}

/** @param {number} angle in rad @returns {string} the tilt of the track */
export function slopeText(angle) {
  const size = short((Math.abs(angle) * 180) / Math.PI);
  if (size === "0") return "0°: the track is level";
  return `${size}° down to the ${angle > 0 ? "right" : "left"}`;
}

/**
 * When pushes begin and end, with what to say; these are no events of the run itself.
 * @param {Header} header @param {boolean} forces whether they may be told @returns {{t: number, sentence: string}[]}
 */
export function pushMarks({ effects, until }, forces) {
  /** @type {{t: number, sentence: string}[]} */
  const marks = [];
  for (const effect of effects) {
    if (effect.kind !== "push" || !effect.active) continue;
    const who = `The push on ${effect.carts[0]} by ${agent(effect)}`;
    const { from = 0, until: end, force = 0 } = effect.numbers;
    const size = forces ? `: ${pushText(force)}` : "";
    if (from <= until) marks.push({ t: from, sentence: `${who} begins${size}.` });
    if (end !== undefined && from < end && end <= until) {
      marks.push({ t: end, sentence: `${who} ends.` });
    }
  }
  return marks;
}

/** @param {string[]} names @returns {string} “A”, “A and B”, “A, B and C” */
function listed(names) {
  return names.length > 1
    ? `${names.slice(0, -1).join(", ")} and ${names.at(-1)}`
    : String(names[0]);
}
