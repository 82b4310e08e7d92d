/** Drag by the air. It has no shape: only its force is drawn. */

import { listed } from "../../view/bodies.js";
import { tr } from "../../view/language.js";
import { short } from "../../view/numbers.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */

/** @type {EffectView} */
export default {
  name: tr("air resistance"),
  row: 4,
  side: () => "above",
  agent: () => tr("the air"),
  around: tr("air"),
  warms: () => tr("air"),
  phrase({ numbers: { linear, quadratic } }, { everyone, on, seen }) {
    const sizes = [
      linear ? tr("{size} N per {unit}", { size: short(linear), unit: "m/s" }) : "",
      quadratic ? tr("{size} N per {unit}", { size: short(quadratic), unit: "(m/s)²" }) : "",
    ].filter(Boolean);
    return [
      everyone ? tr("drag by the air") : tr("drag on {carts} by the air", { carts: on }),
      seen(listed(sizes) || "0 N"),
    ];
  },
};
