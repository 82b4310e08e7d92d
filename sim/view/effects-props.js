/**
 * What an effect looks like: coil, magnets, hand, exploder, rough track, tilt. Pieces are elements of
 * the picture. Twin of `sim/pages/widget/effects_props.py`.
 */

import { actsAt } from "./effects-forces.js";
import { slopeText } from "./effects-words.js";
import { tr } from "./language.js";
import { px } from "./numbers.js";
import { bodyWidth, PUSH } from "./shapes.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Effect} Effect */
/** @typedef {import("./types.js").Layout} Layout */
/** @typedef {(name: string, side: "left" | "right") => number} Face drawing coordinate of a side of a body */
/** @typedef {(name: string) => number} Centre drawing coordinate of the middle of a cart */
/** @typedef {{key: string, cls: string, d?: string, text?: string, x?: string, y?: string, anchor?: string}} Piece */

const TURNS = 9; // of a coil
const LEAD = 5; // units of straight wire at each end of a coil
const COIL = 7; // half its height
const TOOTH = 4; // units of the rough track
const POLE = 12; // units, width of a pole of a magnet
const POLES = [
  ["N", "carts-north"],
  ["S", "carts-south"], // only where there is room
];
const STEEPEST = 22; // units, height of the wedge
/** @type {Record<string, number>} */
const WEDGE = { wide: 120, narrow: 90 }; // units, length of the wedge

/** The pieces of all effects that are on. */
/** @param {Header} header @param {Layout} layout @param {number} t in s @param {Face} face @param {Centre} centre @returns {Piece[]} */
export function props(header, layout, t, face, centre) {
  return header.effects
    .filter(({ active }) => active)
    .flatMap((effect) => {
      const key = `${effect.kind} ${effect.index}`;
      const y = layout.track;
      const [a, b] = effect.between ?? ["", ""];
      switch (effect.kind) {
        case "friction":
          return rough(effect, header, layout, key, face, centre);
        case "incline":
          return tilt(effect, layout, key);
        case "push":
          return actsAt(effect, t) ? [hand(effect, header, layout, key, centre)] : [];
        case "spring":
          return springCoil(effect, layout, key, face(a, "right"), face(b, "left"));
        case "magnets":
          return [
            ...magnet(`${key} ${a}`, face(a, "right"), y, -1, layout),
            ...magnet(`${key} ${b}`, face(b, "left"), y, 1, layout),
          ];
        case "release":
          if (t >= (effect.numbers.at ?? 0)) return [];
          return exploder(key, (face(a, "right") + face(b, "left")) / 2, y);
        default:
          return [];
      }
    });
}

/** @param {number} start @param {number} end @param {number} y @returns {string} a wire of always the same turns */
export function coil(start, end, y, turns = TURNS, high = COIL) {
  const span = Math.max(0, end - start);
  const lead = Math.min(LEAD, span / 4);
  const step = (span - 2 * lead) / turns;
  let d = `M${px(start)} ${px(y)}L${px(start + lead)} ${px(y)}`;
  for (let k = 0; k < turns; k += 1) {
    d += `L${px(start + lead + (k + 0.5) * step)} ${px(k % 2 === 0 ? y - high : y + high)}`;
  }
  return `${d}L${px(start + span - lead)} ${px(y)}L${px(start + span)} ${px(y)}`;
}

/** The coil, and a measure of its natural length above it. */
/** @param {Effect} effect @param {Layout} layout @param {string} key @param {number} start @param {number} end @returns {Piece[]} */
function springCoil(effect, layout, key, start, end) {
  const length = (effect.numbers.length ?? 0) * layout.scale;
  const [a, b] = effect.between ?? ["", ""];
  const middle = (start + end) / 2;
  const low = a === "left" ? start : b === "right" ? end - length : middle - length / 2;
  const y = layout.track - PUSH - COIL - 5;
  return [
    { key, cls: "carts-coil", d: coil(start, end, layout.track - PUSH) },
    {
      key: `${key} natural`,
      cls: "carts-natural",
      d: `M${px(low)} ${px(y - 3)}v6M${px(low)} ${px(y)}h${px(length)}m0 -3v6`,
    },
  ];
}

/** The poles on top of a bumper, north at the facing edge. */
/** @param {string} key @param {number} x @param {number} y @param {1 | -1} way into the body @param {Layout} layout @returns {Piece[]} */
function magnet(key, x, y, way, { kind }) {
  const top = y - 40;
  return POLES.slice(0, kind === "wide" ? 2 : 1).flatMap(([pole, cls], k) => {
    const start = x + way * k * POLE;
    const d = `M${px(start)} ${px(top)}h${px(way * POLE)}v16h${px(-way * POLE)}Z`;
    return [
      { key: `${key} ${pole}`, cls: String(cls), d },
      {
        key: `${key} ${pole} letter`,
        cls: "carts-pole",
        text: String(pole),
        x: px(start + (way * POLE) / 2),
        y: px(top + 12),
        anchor: "middle",
      },
    ];
  });
}

/** A flat hand at the end of an arm, at the box that it pushes, above the bumper. */
/** @param {Effect} effect @param {Header} header @param {Layout} layout @param {string} key @param {Centre} centre @returns {Piece} */
function hand({ carts: [name = ""], numbers }, { bodies }, layout, key, centre) {
  const y = layout.track;
  const way = (numbers.force ?? 0) >= 0 ? 1 : -1;
  const body = bodies.find((one) => one.name === name);
  const x = centre(name) - way * ((body ? bodyWidth(body) * layout.scale : 0) / 2 + 3);
  const d = `M${px(x)} ${px(y - 38)}v14M${px(x)} ${px(y - 31)}h${px(-way * 26)}`;
  return { key, cls: "carts-hand", d };
}

/** A coil squeezed between two plates, and the latch that holds them. */
/** @param {string} key @param {number} x @param {number} y @returns {Piece[]} */
function exploder(key, x, y) {
  const low = y - 28;
  return [
    { key, cls: "carts-coil", d: coil(x - 9, x + 9, low, 7, 4) },
    {
      key: `${key} latch`,
      cls: "carts-latch",
      d: `M${px(x - 10)} ${px(low + 7)}v-15h20v15`,
    },
  ];
}

/** Teeth in the track: all along it, or under the carts that friction acts on. */
/** @param {Effect} effect @param {Header} header @param {Layout} layout @param {string} key @param {Face} face @param {Centre} centre @returns {Piece[]} */
function rough({ carts }, { bodies, track }, layout, key, face, centre) {
  const cls = "carts-rough";
  if (carts.length < bodies.length) {
    return carts.map((name) => {
      const length = (bodies.find((body) => body.name === name)?.length ?? 0) * layout.scale;
      const d = teeth(centre(name) - length / 2, length, layout.track);
      return { key: `${key} ${name}`, cls, d };
    });
  }
  const start = track.left === "wall" ? face("left", "right") : -layout.width;
  const end = track.right === "wall" ? face("right", "left") : 2 * layout.width;
  const tooth = 2 * TOOTH;
  const first = Math.max(start, -tooth + (((start % tooth) + tooth) % tooth)); // moves with the track
  return [{ key, cls, d: teeth(first, Math.min(end, layout.width) - first, layout.track) }];
}

/** @param {number} x @param {number} length @param {number} y @returns {string} so many whole teeth as fit */
function teeth(x, length, y) {
  const count = Math.max(0, Math.floor(length / (2 * TOOTH)));
  return `M${px(x)} ${px(y)}${`l${px(TOOTH)} ${px(TOOTH)}l${px(TOOTH)} ${px(-TOOTH)}`.repeat(count)}`;
}

/** A wedge with the true angle, downhill as the track is, and the angle in words. */
/** @param {Effect} effect @param {Layout} layout @param {string} key @returns {Piece[]} */
function tilt({ numbers }, layout, key) {
  const angle = numbers.angle ?? 0;
  const slope = Math.abs(Math.tan(angle));
  const longest = WEDGE[layout.kind] ?? 0;
  const length = slope ? Math.min(longest, STEEPEST / slope) : longest;
  const [x, y, rise] = [12, layout.tilt, length * slope];
  const [tall, flat] = angle > 0 ? [x, x + length] : [x + length, x];
  const words = angle
    ? tr("track tilted {slope}", { slope: slopeText(angle) })
    : tr("the track is level: 0°");
  const text = angle > 0 ? `${words} →` : angle < 0 ? `← ${words}` : words;
  return [
    {
      key,
      cls: "carts-wedge",
      d: `M${px(tall)} ${px(y)}V${px(y - rise)}L${px(flat)} ${px(y)}Z`,
    },
    {
      key: `${key} words`,
      cls: "carts-tilt",
      text,
      x: px(x + length + 10),
      y: px(y),
      anchor: "start",
    },
  ];
}
