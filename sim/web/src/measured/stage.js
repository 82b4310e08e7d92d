/** The model's carts as they move, with rings where the film saw them. */

import { px } from "../../../view/numbers.js";
import { span, ticks } from "../../../view/scales.js";
import { put, svg } from "../shared/dom.js";

/** @typedef {import("../../../view/measured/types.js").Track} Track */
/** @typedef {import("../../../view/measured/types.js").Curve} Curve */

const [WIDTH, FLOOR, SIDE, TALL] = [640, 62, 16, 34];
const USUAL = 0.2; // m, length of a cart whose marks are at unusual places
const NEAR = 1.5; // frames; a ring is shown while the nearest frame is nearer

export class Stage {
  /** @type {{tracks: Track[], curve: Curve, length: number, names: string[]} | null} */
  #shown = null;
  /** @type {SVGElement[]} */
  #carts = [];
  /** @type {SVGElement[]} */
  #rings = [];
  #scale = 1;
  #left = 0;

  /** @param {Element} place */
  constructor(place) {
    this.place = place;
  }

  /** @param {Track[]} tracks @param {Curve} curve @param {number} distance at the touch, m @param {string[]} names */
  show(tracks, curve, distance, names) {
    const length = distance > 0.1 && distance < 1 ? distance : USUAL;
    this.#shown = { tracks, curve, length, names };
    const all = [...tracks.flatMap((track) => track.value), ...curve.x.flat()];
    const low = all.reduce((a, b) => Math.min(a, b)) - length / 2;
    const high = all.reduce((a, b) => Math.max(a, b)) + length / 2;
    this.#left = low;
    this.#scale = (WIDTH - 2 * SIDE) / (high - low);
    this.#carts = names.map((name, k) => {
      const width = length * this.#scale;
      const group = svg("g", { class: `carts-b${k}` });
      const box = svg("rect", {
        class: "carts-box",
        x: px(-width / 2),
        y: FLOOR - TALL,
        width: px(width),
        height: TALL,
        rx: 3,
      });
      const label = svg("text", {
        class: "carts-name",
        y: FLOOR - 12,
        "text-anchor": "middle",
      });
      label.textContent = name.length > 8 ? `${name.slice(0, 7)}…` : name;
      group.append(box, label);
      return group;
    });
    this.#rings = names.map((_, k) =>
      svg("circle", {
        class: `carts-measured-ring carts-b${k}`,
        r: 7,
        cy: FLOOR - TALL - 12,
      }),
    );
    const ruler = span(low, high, 7);
    const decimals = Math.max(0, Math.ceil(-Math.log10(ruler.step) - 1e-9));
    this.place.replaceChildren(
      svg("path", { class: "carts-rule", d: `M0 ${FLOOR}H${WIDTH}` }),
      ...ticks(ruler).map((tick) => {
        const at = px(this.#at(tick));
        return svg("path", { class: "carts-rule", d: `M${at} ${FLOOR}v6` });
      }),
      ...ticks(ruler).map((tick) => {
        const number = svg("text", {
          class: "carts-tick-x",
          x: px(this.#at(tick)),
          y: FLOOR + 20,
        });
        number.textContent = `${tick.toFixed(decimals).replace("-", "−")} m`;
        return number;
      }),
      ...this.#carts,
      ...this.#rings,
    );
  }

  /** @param {number} x m */
  #at(x) {
    return SIDE + (x - this.#left) * this.#scale;
  }

  /** Where the model's carts are, in m. @param {number} time s @returns {Record<string, number>} by name */
  places(time) {
    const { names, curve } = this.#shown ?? { names: [], curve: { t: [], x: [] } };
    return Object.fromEntries(
      names.map((name, k) => [name, between(curve.t, curve.x[k] ?? [], time)]),
    );
  }

  /** @param {number} time s */
  at(time) {
    if (!this.#shown) return;
    const { tracks, curve } = this.#shown;
    for (const [k, cart] of this.#carts.entries()) {
      const x = between(curve.t, curve.x[k] ?? [], time);
      put(cart, "transform", `translate(${px(this.#at(x), 2)} 0)`);
      const track = tracks[k];
      const ring = this.#rings[k];
      if (!track || !ring) continue;
      const nearest = closest(track.t, time);
      const frame = (Number(track.t.at(-1)) - Number(track.t[0])) / (track.t.length - 1);
      const seen = Math.abs(Number(track.t[nearest]) - time) <= NEAR * frame;
      put(ring, "cx", px(this.#at(Number(track.value[nearest])), 2));
      put(ring, "visibility", seen ? "visible" : "hidden");
    }
  }
}

/** @param {number[]} times rising @param {number} t */
function closest(times, t) {
  let k = times.findIndex((time) => time >= t);
  if (k < 0) k = times.length - 1;
  const before = Math.max(0, k - 1);
  return Math.abs(Number(times[before]) - t) < Math.abs(Number(times[k]) - t) ? before : k;
}

/** @param {number[]} times @param {number[]} values @param {number} t */
function between(times, values, t) {
  let k = times.findLastIndex((time) => time <= t);
  k = Math.min(Math.max(k, 0), Math.max(0, times.length - 2));
  const [a, b] = [Number(times[k]), Number(times[k + 1])];
  const part = b > a ? Math.min(1, Math.max(0, (t - a) / (b - a))) : 0;
  return Number(values[k]) + part * (Number(values[k + 1]) - Number(values[k]));
}
