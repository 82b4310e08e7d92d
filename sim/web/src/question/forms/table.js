/** A table to fill in: each cell a number with a unit, marked by itself; and the points that it makes. */

import { fixed, px } from "../../../../view/numbers.js";
import { axis, axisDecimals, ticks } from "../../../../view/scales.js";
import { put, svg } from "../../shared/dom.js";
import { readNumber, withoutUnit, withUnit } from "../marking/typed-number.js";
import { mark } from "./part-mark.js";

const [LEFT, RIGHT, TOP, BOTTOM] = [50, 305, 15, 160]; // of the plot, as the template draws its axes
const COUNT = 4; // numbers on an axis, about

/** @typedef {{unit: string, units: Record<string, number>}} Cell */
/** @typedef {{cells: Record<string, Cell>, rows: unknown[], plot: [number, number] | null, given: Record<string, number>}} Facts */

/** @param {HTMLElement} root @param {() => void} changed @param {Facts} facts @returns {import("../element.js").Form} */
export function tableForm(root, changed, facts) {
  const places = /** @type {HTMLElement[]} */ ([...root.querySelectorAll("[data-cell]")]);
  const name = (/** @type {HTMLElement} */ place) => String(place.dataset.cell);
  const box = (/** @type {HTMLElement} */ place) =>
    /** @type {HTMLInputElement} */ (place.querySelector("input"));
  const label = (/** @type {HTMLElement} */ place) => box(place).getAttribute("aria-label") ?? "";
  const unit = (/** @type {HTMLElement} */ place) => facts.cells[name(place)]?.unit ?? "";
  const read = (/** @type {HTMLElement} */ place) =>
    readNumber(box(place).value, facts.cells[name(place)]?.units ?? {});
  const filled = () => places.filter((place) => box(place).value.trim());
  const draw = () => facts.plot && plot(root, facts, typed());
  const typed = () =>
    Object.fromEntries(
      filled().map((place) => {
        const found = read(place);
        return [name(place), "value" in found ? found.value : box(place).value];
      }),
    );
  for (const place of places) {
    box(place).addEventListener("input", () => {
      for (const other of places) mark(other, "");
      changed();
      draw();
    });
  }
  draw();
  return {
    get value() {
      return typed();
    },
    set value(value) {
      for (const place of places) {
        const kept = value && Object.hasOwn(value, name(place)) ? value[name(place)] : "";
        box(place).value = String(kept);
        mark(place, ""); // what stood beside it was of another number
      }
      draw();
    },
    recall(said, value) {
      this.value = value;
      const parts = said.split("; ");
      for (const place of filled()) {
        const part = parts.find((one) => one.startsWith(`${label(place)}: `));
        const { value: plain } = box(place);
        if (part) box(place).value = withoutUnit(part.slice(label(place).length + 2), unit(place));
        if (typed()[name(place)] !== value[name(place)]) box(place).value = plain;
      }
    },
    enable(on) {
      for (const place of places) box(place).readOnly = !on;
    },
    said: () =>
      filled()
        .map((place) => `${label(place)}: ${withUnit(box(place).value, unit(place))}`)
        .join("; "),
    problem: () => {
      for (const place of filled()) {
        const found = read(place);
        if ("problem" in found) return `${label(place)}: ${found.problem}`;
      }
      return "";
    },
    marked: (shown) => {
      for (const place of filled())
        mark(place, shown.includes(`cell-${name(place)}`) ? "right" : "wrong");
    },
  };
}

/** The points that have both numbers, on axes from zero. @param {HTMLElement} root @param {Facts} facts @param {Record<string, unknown>} value */
function plot(root, { rows, plot, given }, value) {
  const known = /** @type {Record<string, unknown>} */ ({ ...given, ...value });
  const [x, y] = plot ?? [1, 2];
  const points = rows
    .map((_, r) => [known[`${r + 1}-${x}`], known[`${r + 1}-${y}`]])
    .filter((pair) => pair.every((number) => typeof number === "number"));
  const columns = [0, 1].map((k) => /** @type {number[]} */ (points.map((point) => point[k])));
  const [across, up] = columns.map((all) => axis(Math.min(0, ...all), Math.max(0, ...all), COUNT));
  if (!across || !up) return;
  const at = (/** @type {number} */ number) =>
    px(LEFT + ((number - across.low) / (across.high - across.low)) * (RIGHT - LEFT));
  const high = (/** @type {number} */ number) =>
    px(BOTTOM - ((number - up.low) / (up.high - up.low)) * (BOTTOM - TOP));
  const numbers = (/** @type {import("../../../../view/scales.js").Axis} */ one) =>
    ticks(one).map((tick) => ({ tick, text: fixed(tick, axisDecimals(one)) }));
  const lines = (/** @type {number[]} */ xs, /** @type {number[]} */ ys) =>
    xs.map((one) => `M${at(one)} ${TOP}V${BOTTOM}`).join("") +
    ys.map((one) => `M${LEFT} ${high(one)}H${RIGHT}`).join("");
  const part = (/** @type {string} */ name) =>
    /** @type {Element} */ (root.querySelector(`.carts-q-plot .${name}`));
  put(part("carts-grid"), "d", lines(ticks(across), ticks(up)));
  put(part("carts-q-axes"), "d", lines([0], [0]));
  const place = /** @type {Element} */ (root.querySelector(".carts-q-points"));
  place.replaceChildren(
    ...numbers(across).map(({ tick, text }) =>
      tickText(text, at(tick), `${BOTTOM + 16}`, "middle"),
    ),
    ...numbers(up).map(({ tick, text }) => tickText(text, `${LEFT - 6}`, high(tick), "end")),
    ...points.map(([a, b]) => svg("circle", { cx: at(Number(a)), cy: high(Number(b)), r: 4.5 })),
  );
}

/** @param {string} text @param {string} x @param {string} y @param {string} anchor */
function tickText(text, x, y, anchor) {
  const made = svg("text", { x, y, "text-anchor": anchor });
  made.textContent = text;
  return made;
}
