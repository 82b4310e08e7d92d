/** What acts in a scene, in words. Twin of `sim/pages/widget/effects_words.py`. */

import { agent } from "./effects-forces.js";
import { tr } from "./language.js";
import { listed } from "./listed.js";
import { short } from "./numbers.js";
import { body, EFFECTS } from "./words.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Effect} Effect */

/** @type {Record<string, string>} */
const LEFT_OUT = { ...EFFECTS, release: tr("exploders") };

/** @param {Header} header @param {boolean} numbers false: they would tell a force @returns {string} in and out of the model */
export function actingSentences(header, numbers) {
  if (!header.effects.length) return "";
  const acting = header.effects
    .filter(({ active }) => active)
    .map((effect) => phrase(effect, header, numbers));
  const inside = acting.length
    ? acting.join("; ")
    : tr("nothing but the contacts between the carts");
  const leftOut = header.notSimulated.map((name) => LEFT_OUT[name] ?? name).join(", ");
  const model = tr("In this model: {effects}.", { effects: inside });
  if (!leftOut) return model;
  const outside = tr("Left out: {effects}.", { effects: leftOut });
  return `${model} ${outside}`;
}

/** @param {Effect} effect @param {Header} header @param {boolean} numbers */
function phrase(effect, header, numbers) {
  const { kind, numbers: n, carts, between } = effect;
  const names = between ?? carts;
  const everyone = carts.length === header.bodies.length;
  const on = listed(carts);
  const both = listed(names.map(body));
  const told = (/** @type {string[]} */ ...parts) => parts.filter(Boolean).join(", ");
  const seen = (/** @type {string} */ text) => (numbers ? text : "");
  const value = (/** @type {string} */ key) => n[key] ?? 0;
  switch (kind) {
    case "friction": {
      const held = n.static ?? value("coefficient");
      const rest = tr("(at rest up to {coefficient})", { coefficient: short(held) });
      const size = `μ = ${short(value("coefficient"))}`;
      return told(
        everyone
          ? tr("friction by the track")
          : tr("friction on {carts} by the track", { carts: on }),
        seen(held > value("coefficient") ? `${size} ${rest}` : size),
      );
    }
    case "incline":
      return told(
        everyone ? tr("a slope") : tr("a slope on {carts}", { carts: on }),
        slopeText(value("angle")),
      );
    case "drag": {
      const parts = [
        ["linear", "m/s"],
        ["quadratic", "(m/s)²"],
      ]
        .filter(([key]) => value(String(key)))
        .map(([key, unit]) =>
          tr("{size} N per {unit}", { size: short(value(String(key))), unit: String(unit) }),
        );
      return told(
        everyone ? tr("drag by the air") : tr("drag on {carts} by the air", { carts: on }),
        seen(parts.length ? listed(parts) : "0 N"),
      );
    }
    case "push":
      return told(
        tr("a push on {cart} by {agent}", { cart: String(names[0]), agent: agent(effect) }),
        seen(pushText(value("force"))),
        pushTimes(effect),
      );
    case "spring": {
      const length = tr("natural length {length} m", { length: short(value("length")) });
      return told(
        tr("a spring between {bodies}", { bodies: both }),
        n.damping ? tr("damped") : "",
        seen(`${short(value("stiffness"))} N/m, ${length}`),
      );
    }
    case "magnets":
      return tr("magnets on {bodies}, like poles facing", { bodies: both });
    default:
      return told(
        tr("an exploder between {bodies}", { bodies: both }),
        seen(`${short(value("energy"))} J`),
        tr("at {time} s", { time: short(value("at")) }),
      );
  }
}

/** @param {Header} header @returns {boolean} springs and magnets act without contact */
function isLinked({ effects }) {
  return effects.some(({ kind }) => kind === "spring" || kind === "magnets");
}

/** @param {Header} header @returns {string} what the graph of F shows, with its sign */
export function forceName(header) {
  return isLinked(header) ? tr("Force between them") : tr("Contact force");
}

/** @param {Header} header @returns {string} what the graph of F shows, without a sign */
export function sizeName(header) {
  return isLinked(header) ? tr("Size of the force between them") : tr("Size of the contact force");
}

/** @param {number} force in N @returns {string} with its direction */
export function pushText(force) {
  const size = short(Math.abs(force));
  return force >= 0 ? tr("{size} N to the right", { size }) : tr("{size} N to the left", { size });
}

/** When a push lasts; nothing where it always does. @param {Effect} effect */
function pushTimes({ numbers }) {
  const { from = 0, until } = numbers;
  if (until !== undefined) {
    return tr("from {from} s to {until} s", { from: short(from), until: short(until) });
  }
  return from ? tr("from {from} s", { from: short(from) }) : "";
}

/** @param {number} angle in rad @returns {string} the tilt of the track */
export function slopeText(angle) {
  const size = short((Math.abs(angle) * 180) / Math.PI);
  if (size === "0") return tr("0°: the track is level");
  return angle > 0
    ? tr("{angle}° down to the right", { angle: size })
    : tr("{angle}° down to the left", { angle: size });
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
    const who = { cart: String(effect.carts[0]), agent: agent(effect) };
    const { from = 0, until: end, force = 0 } = effect.numbers;
    const begins = forces
      ? tr("The push on {cart} by {agent} begins: {force}.", { ...who, force: pushText(force) })
      : tr("The push on {cart} by {agent} begins.", who);
    if (from <= until) marks.push({ t: from, sentence: begins });
    if (end !== undefined && from < end && end <= until) {
      marks.push({ t: end, sentence: tr("The push on {cart} by {agent} ends.", who) });
    }
  }
  return marks;
}
