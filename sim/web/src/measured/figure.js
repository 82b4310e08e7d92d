/** Readings over time as points, the model as lines, what is left over below. */

import { fixed, px } from "../../../view/numbers.js";
import { axisDecimals, span, ticks } from "../../../view/scales.js";
import { put, svg } from "../shared/dom.js";

/** @typedef {import("../../../view/scales.js").Axis} Axis */
/** @typedef {import("../../../view/measured/types.js").Track} Track */

const [LEFT, RIGHT, TOP, BOTTOM] = [78, 630, 10, 250]; // on a phone “−200” and the unit stand at the left
const LOW = { top: 8, bottom: 104 }; // of the residuals
const ROOM = 0.06; // of the values, above and below the points
const HEAD = 1.15; // of the greatest residual

/** @param {number[][]} lists @returns {[number, number]} */
function reach(lists) {
  let [low, high] = [Infinity, -Infinity];
  for (const list of lists) {
    for (const value of list) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return [low, high];
}

/** @param {Axis} axis @param {number} value */
const across = (axis, value) =>
  LEFT + ((value - axis.low) / (axis.high - axis.low)) * (RIGHT - LEFT);

/** @param {Axis} axis @param {number} value @param {number} top @param {number} bottom */
const up = (axis, value, top = TOP, bottom = BOTTOM) =>
  bottom - ((value - axis.low) / (axis.high - axis.low)) * (bottom - top);

/** @param {Track[]} tracks */
function planes(tracks) {
  const [begin, end] = reach(tracks.map((track) => track.t));
  const [low, high] = reach(tracks.map((track) => track.value));
  const room = ROOM * (high - low) || 1;
  return { t: span(begin, end, 8), x: span(low - room, high + room, 8) };
}

/** Not quite nothing: a PDF leaves out lines without length that end in squares. */
const DOT = "h0.01";

/** @param {number[]} t @param {number[]} values @param {Axis} axis @param {Axis} up_ @param {[number, number]} room */
function dots(t, values, axis, up_, room = [TOP, BOTTOM]) {
  return t
    .map((time, k) => `M${px(across(axis, time))} ${px(up(up_, Number(values[k]), ...room))}${DOT}`)
    .join("");
}

export class Figure {
  /** @type {SVGElement | null} */
  #cursor = null;
  /** @type {Axis | null} */
  #axis = null;

  /** @param {Element} place @param {Element} left for the residuals */
  constructor(place, left) {
    this.place = place;
    this.left = left;
  }

  /**
   * @param {Track[]} tracks @param {{time: string, value: string}} heads what the axes say
   * @param {{t: number[], x: number[][]} | null} curve of the model @param {number | null} touch
   */
  show(tracks, heads, curve, touch = null) {
    const { t, x } = planes(tracks);
    this.#axis = t;
    this.#cursor = svg("path", { class: "carts-measured-cursor" });
    this.place.replaceChildren(
      ...frame(t, x, BOTTOM, TOP, heads),
      ...(touch === null ? [] : band(t, touch, TOP, BOTTOM)),
      ...tracks.map((track, k) =>
        svg("path", {
          class: `carts-measured-dots carts-b${k}`,
          d: dots(track.t, track.value, t, x),
        }),
      ),
      model(curve, t, x),
      this.#cursor,
    );
  }

  /** @param {Track[]} tracks @param {number[][]} residuals in m or N @param {string} unit @param {number} factor to that unit */
  rest(tracks, residuals, unit, factor) {
    const { t } = planes(tracks);
    const [low, high] = reach(residuals);
    const most = HEAD * factor * Math.max(1e-12, -low, high);
    const axis = span(-most, most, 6);
    this.left.toggleAttribute("hidden", false);
    this.left.replaceChildren(
      ...frame(t, axis, LOW.bottom, LOW.top, { value: unit }),
      svg("path", {
        class: "carts-measured-zero",
        d: `M${LEFT} ${px(up(axis, 0, LOW.top, LOW.bottom))}H${RIGHT}`,
      }),
      ...tracks.map((track, k) =>
        svg("path", {
          class: `carts-measured-dots carts-measured-small carts-${tracks.length > 1 ? `b${k}` : "total"}`,
          d: dots(
            track.t,
            (residuals[k] ?? []).map((value) => factor * value),
            t,
            axis,
            [LOW.top, LOW.bottom],
          ),
        }),
      ),
    );
  }

  /** Marks an instant. @param {number} time s */
  at(time) {
    if (!this.#cursor || !this.#axis) return;
    put(this.#cursor, "d", `M${px(across(this.#axis, time))} ${TOP}V${BOTTOM}`);
  }
}

/**
 * The lines of the model. Where one leaves the picture it is cut: along its edge it would look like a cart at rest.
 * @param {{t: number[], x: number[][]} | null} curve @param {Axis} t @param {Axis} x
 */
function model(curve, t, x) {
  const [width, height] = [RIGHT - LEFT, BOTTOM - TOP];
  const room = svg("svg", { x: LEFT, y: TOP, width, height });
  put(room, "viewBox", `${LEFT} ${TOP} ${width} ${height}`);
  const at = (/** @type {number} */ n) => px(across(t, Number(curve?.t[n])));
  for (const [k, values] of (curve?.x ?? []).entries()) {
    const d = values.map((value, n) => `${n ? "L" : "M"}${at(n)} ${px(up(x, value))}`).join("");
    room.append(svg("path", { class: `carts-measured-curve carts-b${k}`, d }));
  }
  return room;
}

/** @param {Axis} t @param {number} touch @param {number} top @param {number} bottom */
function band(t, touch, top, bottom) {
  if (touch < t.low || touch > t.high) return [];
  return [
    svg("path", {
      class: "carts-measured-touch",
      d: `M${px(across(t, touch))} ${top}V${bottom}`,
    }),
  ];
}

/** Grid lines with their numbers. @param {Axis} t @param {Axis} x @param {number} bottom @param {number} top @param {{time?: string, value: string}} heads */
function frame(t, x, bottom, top, { time, value }) {
  const parts = [];
  for (const tick of ticks(t)) {
    const at = px(across(t, tick));
    parts.push(svg("path", { class: "carts-grid", d: `M${at} ${top}V${bottom}` }));
    parts.push(text("carts-tick-x", at, bottom + 16, fixed(tick, axisDecimals(t))));
  }
  for (const tick of ticks(x)) {
    const at = px(up(x, tick, top, bottom));
    parts.push(svg("path", { class: "carts-grid", d: `M${LEFT} ${at}H${RIGHT}` }));
    parts.push(text("carts-tick-y", LEFT - 6, Number(at) + 4, fixed(tick, axisDecimals(x))));
  }
  const label = svg("text", {
    class: "carts-unit",
    transform: `translate(18 ${(top + bottom) / 2}) rotate(-90)`,
    "text-anchor": "middle",
  });
  label.textContent = value;
  parts.push(label);
  if (time) {
    const name = text("carts-unit", RIGHT, bottom + 31, time);
    put(name, "text-anchor", "end");
    parts.push(name);
  }
  return parts;
}

/** @param {string} name @param {string | number} x @param {string | number} y @param {string} words */
function text(name, x, y, words) {
  const made = svg("text", { class: name, x, y });
  made.textContent = words;
  return made;
}
