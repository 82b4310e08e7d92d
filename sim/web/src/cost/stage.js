/** The carts run twice: as stepped, and exactly as a dashed outline; below, the energy of motion. */

import { inParts } from "../../../view/cost/words.js";
import { px, short } from "../../../view/numbers.js";
import { axis, ticks } from "../../../view/scales.js";
import { need, put, svg } from "../shared/dom.js";

/** @typedef {import("../../../view/cost/words.js").CostHeader} CostHeader */

const [WIDTH, FLOOR_Y, SIDE] = [640, 84, 20];
const [LOWEST, TALLEST] = [16, 58]; // drawing units; in between heights follow the masses
const ENERGY = { left: 60, top: 10, right: 388, bottom: 160 };
const MOST = 3; // times the energy at the start, or the greatest of the exact run; what is above is cut off

/**
 * What energies are told in: per cent of that at the start, or joules where a push brings in nearly all of it.
 * @param {number[]} exact J
 */
export function measureOf(exact) {
  const [start, most] = [Number(exact[0]), Math.max(...exact)];
  return inParts(start, most)
    ? { whole: start, unit: "%", ticked: 100 }
    : { whole: most || 1, unit: "J", ticked: most || 1 };
}

export class CostStage {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.stage = need(root, ".carts-cost-stage");
    this.energy = need(root, ".carts-cost-energy");
    /** @type {SVGElement[]} */
    this.carts = [];
    /** @type {SVGElement[]} */
    this.ghosts = [];
    /** @type {SVGElement | null} */
    this.cursor = null;
  }

  /** @param {CostHeader} header @param {ArrayLike<number>} numbers columns as `cost_answer.py` says */
  show(header, numbers) {
    this.header = header;
    const { rows, bodies } = header;
    const column = (/** @type {number} */ k) =>
      Array.from({ length: rows }, (_, row) => Number(numbers[k * rows + row]));
    this.t = column(0);
    const count = bodies.length;
    this.x = bodies.map((_, k) => column(1 + k));
    this.exact = bodies.map((_, k) => column(1 + count + k));
    this.#lay();
    this.#plot(column(1 + 2 * count), column(2 + 2 * count));
    this.at(0);
  }

  /** The room that the exact run takes, and some more; the stepped one may leave the picture. */
  #lay() {
    const { bodies, track } = /** @type {CostHeader} */ (this.header);
    const paths = this.exact ?? [];
    const ends = bodies.flatMap(({ length }, k) => {
      const all = paths[k] ?? [0];
      return [Math.min(...all) - length, Math.max(...all) + length];
    });
    const left = track.left === "wall" ? 0 : Math.min(...ends);
    const right = track.right === "wall" ? Number(track.length) : Math.max(...ends);
    this.scale = (WIDTH - 2 * SIDE) / (right - left);
    this.left = left;
    const heaviest = Math.max(...bodies.map(({ mass }) => mass));
    const shape = (/** @type {number} */ k, /** @type {string} */ name) => {
      const { mass, length } = /** @type {CostHeader["bodies"][0]} */ (bodies[k]);
      const height = LOWEST + ((TALLEST - LOWEST) * mass) / heaviest;
      const width = length * Number(this.scale);
      const box = {
        x: px(-width / 2),
        y: px(FLOOR_Y - height),
        width: px(width),
        height: px(height),
      };
      return svg("rect", { class: name, rx: 3, ...box });
    };
    const group = (/** @type {number} */ k) => {
      const made = svg("g", { class: `carts-b${k % 8}` });
      const name = svg("text", { class: "carts-name", y: FLOOR_Y + 16, "text-anchor": "middle" });
      name.textContent = bodies[k]?.name ?? "";
      made.append(shape(k, "carts-box"), name);
      return made;
    };
    this.carts = bodies.map((_, k) => group(k));
    this.ghosts = bodies.map((_, k) => shape(k, `carts-cost-ghost carts-b${k % 8}`));
    const floor = svg("path", { class: "carts-rule", d: `M0 ${FLOOR_Y}H${WIDTH}` });
    const walls = [];
    if (track.left === "wall") walls.push(this.#place(0));
    if (track.right === "wall") walls.push(this.#place(Number(track.length)));
    this.stage.replaceChildren(
      floor,
      ...walls.map((x) => svg("path", { class: "carts-wall-face", d: `M${px(x)} 14V${FLOOR_Y}` })),
      ...this.carts,
      ...this.ghosts,
    );
  }

  /** @param {number} x in m */
  #place(x) {
    return SIDE + (x - Number(this.left)) * Number(this.scale);
  }

  /** @param {number[]} stepped @param {number[]} exact J */
  #plot(stepped, exact) {
    const { until } = /** @type {CostHeader} */ (this.header);
    const { whole, unit, ticked } = measureOf(exact);
    const { left, top, right, bottom } = ENERGY;
    const finite = stepped.map((value) => (Number.isFinite(value) ? value / whole : MOST));
    const high = Math.min(MOST, Math.max(1, ...finite, ...exact.map((value) => value / whole)));
    const scale = axis(0, ticked * high, 4);
    const y = (/** @type {number} */ part) =>
      bottom - ((ticked * Math.min(part, high)) / scale.high) * (bottom - top);
    const x = (/** @type {number} */ t) => left + (t / until) * (right - left);
    const path = (/** @type {number[]} */ values) =>
      values
        .map((value, k) => `${k ? "L" : "M"}${px(x(Number(this.t?.[k])))} ${px(y(value))}`)
        .join("");
    const parts = ticks(scale)
      .filter((tick) => tick >= 0)
      .flatMap((tick) => {
        const label = svg("text", {
          class: "carts-tick-y",
          x: left - 6,
          y: px(y(tick / ticked) + 4),
        });
        label.textContent = `${short(tick)} ${unit}`;
        return [
          svg("path", { class: "carts-grid", d: `M${left} ${px(y(tick / ticked))}H${right}` }),
          label,
        ];
      });
    const last = svg("text", { class: "carts-tick-x", x: right, y: bottom + 20 });
    last.textContent = `${short(until)} s`;
    const first = svg("text", { class: "carts-tick-x", x: left, y: bottom + 20 });
    first.textContent = "0";
    this.cursor = svg("path", { class: "carts-cost-cursor" });
    this.energy.replaceChildren(
      ...parts,
      first,
      last,
      svg("path", {
        class: "carts-cost-line carts-cost-true",
        d: path(exact.map((e) => e / whole)),
      }),
      svg("path", { class: "carts-cost-line carts-cost-made", d: path(finite) }),
      this.cursor,
    );
  }

  /** Draw the carts at a time, between the samples on straight lines. @param {number} time s */
  at(time) {
    const times = this.t ?? [];
    let k = times.findLastIndex((t) => t <= time);
    k = Math.min(Math.max(k, 0), Math.max(0, times.length - 2));
    const [a, b] = [Number(times[k]), Number(times[k + 1])];
    const part = b > a ? Math.min(1, (time - a) / (b - a)) : 0;
    const between = (/** @type {number[] | undefined} */ xs) => {
      const here = Number(xs?.[k]);
      const x = this.#place(here + part * (Number(xs?.[k + 1] ?? here) - here));
      return Number.isFinite(x) ? Math.min(5000, Math.max(-5000, x)) : 5000;
    };
    for (const [cart, shape] of this.carts.entries()) {
      put(shape, "transform", `translate(${px(between(this.x?.[cart]), 2)} 0)`);
    }
    for (const [cart, shape] of this.ghosts.entries()) {
      put(shape, "transform", `translate(${px(between(this.exact?.[cart]), 2)} 0)`);
    }
    const { left, top, right, bottom } = ENERGY;
    const x = left + (time / Number(this.header?.until ?? 1)) * (right - left);
    if (this.cursor) put(this.cursor, "d", `M${px(x)} ${top}V${bottom}`);
  }
}
