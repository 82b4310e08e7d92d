/**
 * An exploder between two carts: a coil squeezed between two plates, and the latch that holds them. With
 * a stiffness the coil is as long as the room that it has made, until it lies on the track.
 */

import { tr } from "../../view/language.js";
import { px, short } from "../../view/numbers.js";
import { coil } from "../../view/shapes.js";
import { valueAt } from "../../view/trajectory.js";

/** @typedef {import("../../view/types.js").EffectView} EffectView */
/** @typedef {import("../../view/types.js").Effect} Effect */
/** @typedef {import("../../view/types.js").Run} Run */

const HALF = 9; // units, half the length of the coil
const TURNS = 7;
const HIGH = 4; // half its height
const ABOVE = 28; // units above the track

/** @type {EffectView} */
export default {
  name: tr("a release between the carts"),
  leftOut: tr("springs that are let go"),
  link: tr("spring"),
  lasts: ({ numbers }) => numbers.stiffness !== undefined, // else an impulse: no force to be drawn
  stored: tr("in the squeezed spring"),
  acts: ({ numbers: { at = 0, stiffness } }, t) => t < at || stiffness !== undefined,
  phrase: ({ numbers: { energy = 0, at = 0, stiffness } }, { both, seen }) => [
    stiffness === undefined
      ? tr("an exploder between {bodies}", { bodies: both })
      : tr("a squeezed spring between {bodies} that is let go", { bodies: both }),
    seen(`${short(energy)} J`),
    stiffness === undefined ? "" : seen(`${short(stiffness)} N/m`),
    tr("at {time} s", { time: short(at) }),
  ],
  pieces(effect, { key, run, t, layout, face }) {
    const [a, b] = effect.between ?? ["", ""];
    const [begun, ended] = pushes(effect, run);
    const low = layout.track - ABOVE;
    const ends = [face(a, "right"), face(b, "left")].map(Number);
    if (t > ended) {
      const there = edge(run, a, ended) - edge(run, a, t); // from where the edge is now
      const start = Number(ends[0]) + there * layout.scale - HALF;
      const long = (edge(run, b, ended, -1) - edge(run, a, ended)) * layout.scale;
      const lying = coil(start, start + long + 2 * HALF, layout.track - HIGH, TURNS, HIGH);
      return [{ key: `${key} lying`, cls: "carts-coil carts-spent", behind: true, d: lying }];
    }
    const middle = (Number(ends[0]) + Number(ends[1])) / 2;
    const [start = 0, end = 0] = t < begun ? [middle, middle] : ends;
    const wire = coil(start - HALF, end + HALF, low, TURNS, HIGH);
    const plates =
      t < begun
        ? `M${px(start - HALF - 1)} ${px(low + 7)}v-15h20v15`
        : `M${px(start - HALF - 1)} ${px(low + 7)}v-14M${px(end + HALF + 1)} ${px(low + 7)}v-14`;
    return [
      { key, cls: "carts-coil", d: wire },
      { key: `${key} latch`, cls: "carts-latch", d: plates },
    ];
  },
};

/** When it pushes: from, to; both without end where nobody lets it go. @param {Effect} effect @param {Run} run */
function pushes({ between, numbers: { at = 0 } }, { header, trajectory }) {
  const pair = between?.join("-");
  const mine = header.events.filter(({ bodies }) => bodies.join("-") === pair);
  const begun = mine.find(({ kind, t }) => kind === "release" && t === at);
  if (!begun || trajectory.t.length < 2) return [Infinity, Infinity];
  const ended = mine.find(({ kind, t }) => kind === "separate" && t > begun.t);
  return [begun.t, ended?.t ?? Infinity];
}

/** m. The right edge of a cart, or the left one where `direction` is −1. @param {Run} run @param {string} name @param {number} t in s */
function edge({ header, trajectory }, name, t, direction = 1) {
  const half = (header.bodies.find((body) => body.name === name)?.length ?? 0) / 2;
  return (
    valueAt(trajectory.t, trajectory.x[name] ?? [], trajectory.v[name] ?? [], t) + direction * half
  );
}
