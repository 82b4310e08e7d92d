/** Friction by the track: teeth in the track where it acts. */

import { tr } from "../../view/language.js";
import { px, short } from "../../view/numbers.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */

const TOOTH = 4; // units of the rough track

/** @type {EffectView} */
export default {
  name: tr("friction"),
  row: 3,
  side: () => "below",
  agent: () => tr("the track"),
  around: tr("track"),
  earth: true,
  warms: () => tr("track"),
  phrase({ numbers: { coefficient = 0, static: held = coefficient } }, { everyone, on, seen }) {
    const size = `μ = ${short(coefficient)}`;
    const rest = tr("(at rest up to {coefficient})", { coefficient: short(held) });
    return [
      everyone
        ? tr("friction by the track")
        : tr("friction on {carts} by the track", { carts: on }),
      seen(held > coefficient ? `${size} ${rest}` : size),
    ];
  },
  pieces: rough,
};

/** Teeth in the track: all along it, or under the carts that friction acts on. @type {NonNullable<EffectView["pieces"]>} */
function rough({ carts }, { key, header: { bodies, track }, layout, face, centre }) {
  const piece = { cls: "carts-rough", behind: true };
  if (carts.length < bodies.length) {
    return carts.map((name) => {
      const length = (bodies.find((body) => body.name === name)?.length ?? 0) * layout.scale;
      const d = teeth(centre(name) - length / 2, length, layout.track);
      return { ...piece, key: `${key} ${name}`, d };
    });
  }
  const start = track.left === "wall" ? face("left", "right") : -layout.width;
  const end = track.right === "wall" ? face("right", "left") : 2 * layout.width;
  const tooth = 2 * TOOTH;
  const first = Math.max(start, -tooth + (((start % tooth) + tooth) % tooth)); // moves with the track
  const d = teeth(first, Math.min(end, layout.width) - first, layout.track);
  return [{ ...piece, key, d }];
}

/** @param {number} x @param {number} length @param {number} y @returns {string} so many whole teeth as fit */
function teeth(x, length, y) {
  const count = Math.max(0, Math.floor(length / (2 * TOOTH)));
  return `M${px(x)} ${px(y)}${`l${px(TOOTH)} ${px(TOOTH)}l${px(TOOTH)} ${px(-TOOTH)}`.repeat(count)}`;
}
