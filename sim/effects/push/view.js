/** A push from outside: a hand at the box of the cart, as long as it lasts. */

import { tr } from "../../view/language.js";
import { px, short } from "../../view/numbers.js";
import { bodyWidth } from "../../view/shapes.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */
/** @typedef {import("../../view/types.js").Effect} Effect */

/** @type {EffectView} */
export default {
  name: tr("pushes from outside"),
  row: 2,
  side: (force) => (force < 0 ? "right" : "left"),
  around: (_, agent) => agent,
  acts: ({ numbers: { from = 0, until = Infinity } }, t) => t >= from && t < until,
  phrase: (effect, { agent, seen }) => [
    tr("a push on {cart} by {agent}", { cart: String(effect.carts[0]), agent }),
    seen(forceText(effect.numbers.force ?? 0)),
    times(effect),
  ],
  pieces({ carts: [name = ""], numbers: { force = 0 } }, { key, header, layout, centre }) {
    const y = layout.track;
    const way = force >= 0 ? 1 : -1;
    const body = header.bodies.find((one) => one.name === name);
    const x = centre(name) - way * ((body ? bodyWidth(body) * layout.scale : 0) / 2 + 3);
    const d = `M${px(x)} ${px(y - 38)}v14M${px(x)} ${px(y - 31)}h${px(-way * 26)}`;
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
