/** Magnets with like poles facing: the poles on top of the bumpers, north at the facing edge. */

import { tr } from "../../view/language.js";
import { px } from "../../view/numbers.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */

const POLE = 14; // units, width of a pole
const POLES = [
  ["N", "carts-north"],
  ["S", "carts-south"], // only where there is room
];

/** @type {EffectView} */
export default {
  name: tr("magnets"),
  link: tr("magnets"),
  apart: true,
  stored: tr("between the magnets"),
  phrase: (_, { both }) => [tr("magnets on {bodies}, like poles facing", { bodies: both })],
  pieces({ between }, { key, layout, face }) {
    const [a, b] = between ?? ["", ""];
    return [
      ...poles(`${key} ${a}`, face(a, "right"), -1, layout),
      ...poles(`${key} ${b}`, face(b, "left"), 1, layout),
    ];
  },
};

/**
 * @param {string} key @param {number} x @param {1 | -1} direction into the body
 * @param {import("../../view/types.js").Layout} layout @returns {import("../../view/types.js").Piece[]}
 */
function poles(key, x, direction, { kind, track }) {
  const top = track - 40;
  return POLES.slice(0, kind === "wide" ? 2 : 1).flatMap(([pole = "", cls = ""], k) => {
    const start = x + direction * k * POLE;
    const d = `M${px(start)} ${px(top)}h${px(direction * POLE)}v16h${px(-direction * POLE)}Z`;
    const letter = { text: pole, x: px(start + (direction * POLE) / 2), y: px(top + 13) };
    return [
      { key: `${key} ${pole}`, cls, d },
      { key: `${key} ${pole} letter`, cls: "carts-pole", anchor: "middle", ...letter },
    ];
  });
}
