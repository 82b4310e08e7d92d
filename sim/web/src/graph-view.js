/** One graph on the page: curves, axes, key, the cursor linked to the carts. */

import { need, put, say, svg } from "./dom.js";
import * as g from "./graph.js";
import { MARKERS } from "./markers.js";
import { px, speedUnit } from "./numbers.js";
import { seriesOf } from "./series.js";
import { Table } from "./table.js";
import { isTold, valueAt } from "./trajectory.js";
import { graphNote } from "./words.js";

/** @typedef {import("./types.js").Run} Run */
/** @typedef {import("./series.js").Series} Series */

export class GraphView {
  /** @type {Series[]} */
  #curves = [];
  /** @type {Run | null} */
  #run = null;
  /** @type {Run | null} the first one, as the lesson has it: the axes keep to it */
  #first = null;
  /** @type {g.Plane} */
  #plane = g.planeFor([0, 1], [0, 1]);
  /** @type {Element[]} */
  #dots = [];
  #signed = false;
  /** @type {[number, number] | null} */
  #window = null;

  /**
   * @param {HTMLElement} root @param {import("./types.js").Baked} baked
   * @param {(t: number) => void} seek when the reader points at a time
   */
  constructor(root, baked, seek) {
    this.root = root;
    this.quantity = root.dataset.quantity ?? "x";
    this.camera = baked.fence.camera;
    this.reach = baked.view.reach[this.quantity] ?? [0, 0, 1];
    this.per = speedUnit(baked.view.velocity)[0];
    this.plot = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (need(root, ".carts-plot")));
    this.table = new Table(need(root, "details"), this.quantity, baked.view);
    this.sign = /** @type {HTMLButtonElement | null} */ (root.querySelector(".carts-sign"));
    this.sign?.addEventListener("click", () => this.#toggleSign());
    const point = (/** @type {PointerEvent} */ event) => {
      if (event.type === "pointermove" && !(event.buttons & 1)) return;
      const frame = this.plot.getBoundingClientRect();
      const x = ((event.clientX - frame.left) / frame.width) * g.WIDTH;
      const part = Math.min(1, Math.max(0, (x - g.LEFT) / (g.RIGHT - g.LEFT)));
      const { low, high } = this.#plane.time;
      seek(low + part * (high - low));
    };
    this.plot.addEventListener("pointerdown", point);
    this.plot.addEventListener("pointermove", point);
  }

  enable() {
    if (this.sign) this.sign.disabled = false;
  }

  /** @param {Run} run @param {number} t the instant shown */
  show(run, t) {
    if (!isTold(run)) return; // the axes stay as empty as they were baked
    this.#run = run;
    if (run.trajectory.t.length > 1) this.#first ??= run;
    this.#draw(t);
    this.table.show(run, this.#curves);
  }

  /** A part of the time axis, or null for all of it. @param {[number, number] | null} window @param {number} t */
  zoom(window, t) {
    this.#window = window;
    if (this.#run) this.#draw(t);
  }

  /** @param {number} t in s */
  at(t) {
    const run = this.#run;
    if (!run) return;
    const x = px(g.timeX(this.#plane, t));
    put(need(this.root, ".carts-cursor"), "transform", `translate(${x} 0)`);
    this.#curves.forEach((curve, i) => {
      const y = g.valueY(this.#plane, valueAt(run.trajectory.t, curve.values, curve.slopes, t));
      const dot = this.#dots[i];
      if (dot) put(dot, "transform", `translate(${x} ${px(y)})`);
    });
  }

  #toggleSign() {
    this.#signed = !this.#signed;
    this.sign?.setAttribute("aria-pressed", String(this.#signed));
    const name = need(this.root, ".carts-graph-name");
    name.replaceChildren(
      this.#signed ? "Contact force " : "Size of the contact force ",
      Object.assign(document.createElement("i"), { textContent: this.#signed ? "F" : "|F|" }),
      this.#signed ? " in N, + is right" : " in N",
    );
    this.root.dispatchEvent(new CustomEvent("carts-redraw", { bubbles: true }));
  }

  /** @param {number} t */
  #draw(t) {
    const run = /** @type {Run} */ (this.#run);
    const { header, trajectory } = run;
    this.#curves = this.#curvesOf(run);
    const values = g.extent(this.#curves);
    const [low, high, factor] = this.reach;
    const first = g.extent(this.#first ? this.#curvesOf(this.#first) : []);
    const down = this.#signed ? -high : low;
    values[0] = Math.min(values[0], first[0] * factor, down);
    values[1] = Math.max(values[1], first[1] * factor, high);
    this.#plane = g.planeFor(values, this.#window ?? [0, header.until]);
    this.#axes();
    const group = need(this.root, '[data-part="curves"]');
    fit(group, this.#curves.length, () => svg("path"));
    this.#curves.forEach((curve, i) => {
      const line = /** @type {Element} */ (group.children[i]);
      put(line, "class", `carts-curve carts-${curve.style}${curve.over ? " carts-over" : ""}`);
      put(line, "d", g.path(curve, trajectory.t, this.#plane));
    });
    this.#cursor();
    this.#key();
    this.at(t);
  }

  /** @param {Run} run */
  #curvesOf({ header, trajectory }) {
    return seriesOf(this.quantity, header, trajectory, this.camera, this.#signed, this.per);
  }

  #axes() {
    const times = g.timeMarks(this.#plane);
    const rows = g.valueMarks(this.#plane);
    marks(need(this.root, '[data-part="times"]'), times.length, (line, text, i) => {
      const { at, label } = /** @type {{at: string, label: string}} */ (times[i]);
      put(line, "class", "carts-grid");
      put(line, "d", `M${at} ${g.TOP}V${g.BOTTOM}`);
      put(text, "class", "carts-tick-x");
      put(text, "x", at);
      put(text, "y", String(g.BOTTOM + 14));
      say(text, label);
    });
    marks(need(this.root, '[data-part="values"]'), rows.length, (line, text, i) => {
      const { at, textY, label, zero } = /** @type {(typeof rows)[number]} */ (rows[i]);
      put(line, "class", zero ? "carts-zero" : "carts-grid");
      put(line, "d", `M${g.LEFT} ${at}H${g.RIGHT}`);
      put(text, "class", "carts-tick-y");
      put(text, "x", String(g.LEFT - 5));
      put(text, "y", textY);
      say(text, label);
    });
  }

  #cursor() {
    const group = need(this.root, '[data-part="cursor"]');
    fit(group, this.#curves.length + 1, () => svg("path"));
    this.#dots = [...group.children].slice(1);
    this.#dots.forEach((dot, i) => {
      const style = this.#curves[i]?.style ?? "b0";
      put(dot, "class", `carts-dot carts-${style}`);
      put(dot, "d", MARKERS[style] ?? "");
    });
  }

  #key() {
    const key = need(this.root, ".carts-key");
    const note = graphNote(this.quantity, this.#run?.header.events ?? [], this.#curves.length);
    const wanted = [...this.#curves.map((c) => `${c.style}${c.over}${c.label}`), note].join("|");
    if (key.dataset.curves === wanted) return;
    const first = key.dataset.curves === undefined;
    key.dataset.curves = wanted;
    const entries = this.#curves.length + (note ? 1 : 0);
    if (first && key.children.length === entries) return; // as baked
    key.replaceChildren(...this.#curves.map(keyEntry), ...(note ? [span(note)] : []));
  }
}

/** @param {string} text */
function span(text) {
  return Object.assign(document.createElement("span"), { textContent: text });
}

/** @param {Series} curve @returns {HTMLElement} */
function keyEntry(curve) {
  const entry = span("");
  entry.className = `carts-${curve.style}`;
  const sample = svg("svg", {
    viewBox: "0 0 26 10",
    width: 26,
    height: 10,
    "aria-hidden": "true",
    focusable: "false",
  });
  const over = curve.over ? " carts-over" : "";
  sample.append(
    svg("path", { class: `carts-curve carts-${curve.style}${over}`, d: "M0 5H26" }),
    svg("path", {
      class: `carts-dot carts-${curve.style}`,
      d: MARKERS[curve.style] ?? "",
      transform: "translate(13 5)",
    }),
  );
  entry.append(sample, curve.label);
  return entry;
}

/** Exactly `count` children. @param {Element} group @param {number} count @param {() => Element} make */
function fit(group, count, make) {
  while (group.children.length > count) group.lastElementChild?.remove();
  while (group.children.length < count) group.append(make());
}

/** @param {Element} group @param {number} count @param {(line: Element, text: Element, i: number) => void} draw */
function marks(group, count, draw) {
  while (group.children.length > 2 * count) group.lastElementChild?.remove();
  while (group.children.length < 2 * count) group.append(svg("path"), svg("text"));
  for (let i = 0; i < count; i += 1) {
    draw(
      /** @type {Element} */ (group.children[2 * i]),
      /** @type {Element} */ (group.children[2 * i + 1]),
      i,
    );
  }
}
