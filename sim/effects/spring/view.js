/** A spring between two bodies: a coil, and a measure of its natural length above it. */

import { tr } from "../../view/language.js";
import { px, short } from "../../view/numbers.js";
import { COIL, coil, PUSH } from "../../view/shapes.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */

/** @type {EffectView} */
export default {
  name: tr("springs between the carts"),
  link: tr("spring"),
  stored: tr("in the spring"),
  warms: ({ numbers }) => ((numbers.damping ?? 0) > 0 ? tr("spring") : ""),
  phrase({ numbers: { stiffness = 0, length = 0, damping } }, { both, seen }) {
    const natural = tr("natural length {length} m", { length: short(length) });
    return [
      tr("a spring between {bodies}", { bodies: both }),
      damping ? tr("damped") : "",
      seen(`${short(stiffness)} N/m, ${natural}`),
    ];
  },
  pieces({ numbers, between }, { key, layout, face }) {
    const [a, b] = between ?? ["", ""];
    const [start, end] = [face(a, "right"), face(b, "left")];
    const length = (numbers.length ?? 0) * layout.scale;
    const middle = (start + end) / 2;
    const low = a === "left" ? start : b === "right" ? end - length : middle - length / 2;
    const y = layout.track - PUSH - COIL - 5;
    const measure = `M${px(low)} ${px(y - 3)}v6M${px(low)} ${px(y)}h${px(length)}m0 -3v6`;
    return [
      { key, cls: "carts-coil", d: coil(start, end, layout.track - PUSH) },
      { key: `${key} natural`, cls: "carts-natural", d: measure },
    ];
  },
};
