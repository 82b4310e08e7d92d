/** A push from outside: a hand at the box of the cart as long as it lasts; then it lets go. */

import { tr } from "../../view/language.js";
import { px, short } from "../../view/numbers.js";
import { bodyWidth } from "../../view/shapes.js";
import { valueAt } from "../../view/trajectory.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */
/** @typedef {import("../../view/types.js").Effect} Effect */

const LET_GO = 1.5; // s, how long the hand is seen after it has let go
const BACK = 0.2; // s, in which it draws back
const ROOM = 16; // units, how far
const MIDDLE = 29; // units above the track
/** A finger against the cart, the others curled; x from its tip, y from its middle, in units. */
const HAND =
  "M-46 -6L-31 -7C-26 -9 -22 -6 -17 -3.5L-3 -3.5C1 -3.5 1 3 -3 3L-15 3C-10 3 -10 7.5 -15 7.5" +
  "C-11 7.5 -11 12 -16 12C-13 12 -13 16 -18 16C-26 17 -29 14 -32 9L-46 9" +
  "M-15 3h-7M-15 7.5h-6M-16 12h-5M-29 0C-24 0 -21 -1 -19 3M-38 -9h-8v20h8Z";

/** @type {EffectView} */
export default {
  name: tr("pushes from outside"),
  row: 2,
  side: (force) => (force < 0 ? "right" : "left"),
  around: (_, agent) => agent,
  acts: ({ numbers: { from = 0, until = Infinity } }, t) => t >= from && t < until,
  seen: (effect, t) => begun(effect, t) && t < end(effect) + (isHand(effect) ? LET_GO : 0),
  phrase: (effect, { agent, seen }) => [
    tr("a push on {cart} by {agent}", { cart: String(effect.carts[0]), agent }),
    seen(forceText(effect.numbers.force ?? 0)),
    times(effect),
  ],
  pieces(effect, { key, header, run, t, layout, centre }) {
    const { carts, numbers } = effect;
    const name = String(carts[0]);
    const y = layout.track;
    const direction = (numbers.force ?? 0) >= 0 ? 1 : -1;
    const body = header.bodies.find((one) => one.name === name);
    const side = centre(name) - direction * ((body ? bodyWidth(body) * layout.scale : 0) / 2);
    if (isHand(effect)) {
      const past = t - end(effect);
      if (past >= 0 && goesOn(effect, header)) return [];
      const gone = past < 0 ? 0 : direction * ROOM * Math.min(1, past / BACK);
      const left =
        past < 0
          ? side
          : side - (place(run, name, t) - place(run, name, end(effect))) * layout.scale;
      return [{ key, cls: "carts-hand carts-palm", d: hand(left - gone, y - MIDDLE, direction) }];
    }
    const x = side - 3 * direction;
    const d = `M${px(x)} ${px(y - 38)}v14M${px(x)} ${px(y - 31)}h${px(-direction * 26)}`;
    return [{ key, cls: "carts-hand", behind: true, d }];
  },
  marks({ carts, numbers: { from = 0, until: end, force = 0 } }, agent, until, told) {
    const who = { cart: String(carts[0]), agent };
    const begins = told
      ? tr("The push on {cart} by {agent} begins: {force}.", { ...who, force: forceText(force) })
      : tr("The push on {cart} by {agent} begins.", who);
    const marks = from <= until ? [{ t: from, sentence: begins }] : [];
    if (end !== undefined && from < end && end <= until) {
      marks.push({ t: end, sentence: tr("The push on {cart} by {agent} ends.", who) });
    }
    return marks;
  },
};

/** @param {Effect} effect @returns {boolean} whether a hand pushes, and not whoever the scene names */
const isHand = ({ by }) => !by || by === "hand";

/** @param {Effect} effect @param {number} t in s */
const begun = ({ numbers: { from = 0 } }, t) => t >= from;

/** @param {Effect} effect @returns {number} s */
const end = ({ numbers: { until = Infinity } }) => until;

/** Whether the same hand pushes on where this push ends. @param {Effect} effect @param {import("../../view/types.js").Header} header */
function goesOn(effect, { effects }) {
  const on = (/** @type {Effect} */ one) =>
    one.active && one.kind === effect.kind && one.carts[0] === effect.carts[0] && isHand(one);
  return effects.some((one) => on(one) && one !== effect && (one.numbers.from ?? 0) >= end(effect));
}

/** m. Where a cart is. @param {import("../../view/types.js").Run} run @param {string} name @param {number} t in s */
function place({ trajectory: { t: times, x, v } }, name, t) {
  return valueAt(times, x[name] ?? [], v[name] ?? [], t);
}

/** @param {number} x of the palm @param {number} y @param {1 | -1} direction it pushes @returns {string} */
function hand(x, y, direction) {
  let across = true; // the next number is an x, but after v
  let absolute = true;
  return HAND.replace(/[MLCvhZ]|-?[\d.]+/g, (part) => {
    if (/[a-zA-Z]/.test(part)) {
      across = part !== "v";
      absolute = part === part.toUpperCase();
      return part;
    }
    const number = Number(part);
    const shown = across ? direction * number + (absolute ? x : 0) : number + (absolute ? y : 0);
    across = absolute ? !across : across;
    return ` ${px(shown)}`;
  });
}

/** @param {number} force in N @returns {string} with its direction */
function forceText(force) {
  const size = short(Math.abs(force));
  return force >= 0 ? tr("{size} N to the right", { size }) : tr("{size} N to the left", { size });
}

/** When a push lasts; nothing where it always does. @param {Effect} effect */
function times({ numbers: { from = 0, until } }) {
  if (until !== undefined) {
    return tr("from {from} s to {until} s", { from: short(from), until: short(until) });
  }
  return from ? tr("from {from} s", { from: short(from) }) : "";
}
