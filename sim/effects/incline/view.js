/** A tilted track: a wedge with the true angle, downhill as the track is, and the angle in words. */

import { listed } from "../../view/bodies.js";
import { tr } from "../../view/language.js";
import { px, short } from "../../view/numbers.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */

const STEEPEST = 22; // units, height of the wedge
const ROW = 24; // units: of each wedge, as the layout has room for it
/** @type {Record<string, number>} */
const LENGTH = { wide: 120, narrow: 90 }; // units

/** @type {EffectView} */
export default {
  name: tr("a slope"),
  row: 1,
  agent: () => tr("the Earth"),
  earth: true,
  stored: tr("as height, above the lowest point"),
  slope: ({ numbers }) => numbers.angle ?? 0,
  forceName: (on, by) =>
    tr("part of the weight of {on}, along the track: force on {on} by {by}", { on, by }),
  label: (told) => tr("on {on} by {by} (slope): {size} N", told),
  phrase: ({ numbers }, { everyone, on }) => [
    everyone ? tr("a slope") : tr("a slope on {carts}", { carts: on }),
    slopeText(numbers.angle ?? 0),
  ],
  pieces({ index, carts, numbers: { angle = 0 } }, { key, header, layout }) {
    const slope = Math.abs(Math.tan(angle));
    const longest = LENGTH[layout.kind] ?? 0;
    const length = slope ? Math.min(longest, STEEPEST / slope) : longest;
    // A track that is bent between two carts has a wedge for either part, one under the other.
    const inclines = header.effects.filter(({ kind }) => kind === "incline");
    const place = inclines.findIndex((one) => one.index === index);
    const [x, y, rise] = [12, layout.tilt + ROW * Math.max(0, place), length * slope];
    const whose = carts.length < header.bodies.length ? `${listed(carts)}: ` : "";
    const [tall, flat] = angle > 0 ? [x, x + length] : [x + length, x];
    const d = `M${px(tall)} ${px(y)}V${px(y - rise)}L${px(flat)} ${px(y)}Z`;
    const words = {
      text: whose + tiltText(angle),
      x: px(x + length + 10),
      y: px(y),
      anchor: /** @type {const} */ ("start"),
    };
    return [
      { key, cls: "carts-wedge", behind: true, d },
      { key: `${key} words`, cls: "carts-tilt", behind: true, ...words },
    ];
  },
};

/** @param {number} angle in rad */
function tiltText(angle) {
  if (!angle) return tr("the track is level: 0°");
  const words = tr("track tilted {slope}", { slope: slopeText(angle) });
  return angle > 0 ? `${words} →` : `← ${words}`;
}

/** @param {number} angle in rad @returns {string} the tilt of the track */
function slopeText(angle) {
  const size = short((Math.abs(angle) * 180) / Math.PI);
  if (size === "0") return tr("0°: the track is level");
  return angle > 0
    ? tr("{angle}° down to the right", { angle: size })
    : tr("{angle}° down to the left", { angle: size });
}
