/** An exploder between two carts: a coil squeezed between two plates, and the latch that holds them. */

import { tr } from "../../view/language.js";
import { px, short } from "../../view/numbers.js";
import { coil } from "../../view/shapes.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */

const HALF = 9; // units, half the length of the coil
const TURNS = 7;
const HIGH = 4; // half its height

/** @type {EffectView} */
export default {
  name: tr("a release between the carts"),
  leftOut: tr("exploders"),
  link: null, // it acts at one instant: an impulse, no force to be drawn
  acts: ({ numbers: { at = 0 } }, t) => t < at,
  phrase: ({ numbers: { energy = 0, at = 0 } }, { both, seen }) => [
    tr("an exploder between {bodies}", { bodies: both }),
    seen(`${short(energy)} J`),
    tr("at {time} s", { time: short(at) }),
  ],
  pieces({ between }, { key, layout, face }) {
    const [a, b] = between ?? ["", ""];
    const x = (face(a, "right") + face(b, "left")) / 2;
    const low = layout.track - 28;
    const latch = `M${px(x - HALF - 1)} ${px(low + 7)}v-15h20v15`;
    return [
      { key, cls: "carts-coil", d: coil(x - HALF, x + HALF, low, TURNS, HIGH) },
      { key: `${key} latch`, cls: "carts-latch", d: latch },
    ];
  },
};
