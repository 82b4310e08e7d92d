/** One graph on the page: curves, axes, key, the cursor linked to the carts. */

import { forceName, sizeName } from "../../../../view/effects-words.js";
import * as g from "../../../../view/graph.js";
import { tr } from "../../../../view/language.js";
import { MARKERS } from "../../../../view/markers.js";
import { px, speedUnit } from "../../../../view/numbers.js";
import { seriesOf } from "../../../../view/series.js";
import { isTold, valueAt } from "../../../../view/trajectory.js";
import { graphNote } from "../../../../view/words.js";
import { fit, need, put, svg } from "../../shared/dom.js";
import { onPointed } from "../../shared/follow.js";
import { ghostCurves } from "../how/ghost.js";
import { drawAxes } from "./axes.js";
import { ImpulseLayer } from "./impulse-layer.js";
import { Key } from "./key.js";
import { hasLedger, LedgerLayer } from "./ledger-layer.js";
import { Table } from "./table.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {import("../../../../view/series.js").Series} Series */

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
  /** @type {Run | null} a run that is drawn pale behind the one that is shown */
  behind = null;
  /** Draws what somebody else knows of it behind the curves. @type {(graph: GraphView, plane: g.Plane) => void} */
  drawn = () => {};
  #pressed = false; // “with sign”, “as a ledger”
  #t = 0; // s, the instant shown
  #seen = Infinity; // s, as far as the run was watched
  /** @type {[number, number] | null} */
  #window = null;

  /**
   * @param {HTMLElement} root @param {import("../../../../view/types.js").Baked} baked
   * @param {(t: number) => void} seek when the reader points at a time
   */
  constructor(root, baked, seek) {
    this.root = root;
    this.quantity = root.dataset.quantity ?? "x";
    this.camera = baked.fence.camera;
    this.signedName = forceName(baked.run.header);
    this.name = sizeName(baked.run.header);
    this.reach = baked.view.reach[this.quantity] ?? [0, 0, 1, 0];
    this.per = speedUnit(baked.view.velocity)[0];
    this.plot = /** @type {SVGSVGElement} */ (/** @type {unknown} */ (need(root, ".carts-plot")));
    this.key = new Key(need(root, ".carts-key"));
    this.table = new Table(need(root, "details"), this.quantity, baked.view);
    this.button = /** @type {HTMLButtonElement | null} */ (root.querySelector(".carts-sign"));
    this.impulse = this.quantity === "F" ? new ImpulseLayer(root, baked.view) : null;
    this.ledger =
      this.quantity === "energy" && hasLedger(baked) ? new LedgerLayer(root, baked) : null;
    if (this.quantity === "energy" && !this.ledger && this.button) this.button.hidden = true;
    this.button?.addEventListener("click", () => this.#toggle());
    onPointed(this.plot, (event) => {
      const frame = this.plot.getBoundingClientRect();
      const x = ((event.clientX - frame.left) / frame.width) * g.WIDTH;
      const part = Math.min(1, Math.max(0, (x - g.LEFT) / (g.RIGHT - g.LEFT)));
      const { low, high } = this.#plane.time;
      seek(low + part * (high - low));
    });
  }

  enable() {
    if (this.button) this.button.disabled = false;
  }

  /** @param {Run} run @param {number} t the instant shown */
  show(run, t) {
    if (!isTold(run)) return; // the axes stay as empty as they were baked
    this.#run = run;
    if (run.trajectory.t.length > 1) this.#first ??= run;
    this.impulse?.show(run);
    this.ledger?.show(run, this.#pressed, () => this.show(run, this.#t));
    this.#draw(t);
    const told = this.#stacked ? (this.ledger?.entries ?? []) : this.#curves;
    this.table.show(run, told, this.#times(run));
  }

  /** Draws the curves as far as they were watched. @param {number} seen in s */
  grow(seen) {
    this.#seen = seen;
    this.table.grow(seen);
    if (this.#run) seen === Infinity ? this.#draw(this.#t) : this.#lines(this.#run);
  }

  /** A part of the time axis, or null for all of it. @param {[number, number] | null} window @param {number} t */
  zoom(window, t) {
    this.#window = window;
    if (this.#run) this.#draw(t);
  }

  /** @param {number} t in s */
  at(t) {
    this.#t = t;
    const run = this.#run;
    if (!run) return;
    const x = px(g.timeX(this.#plane, t));
    this.impulse?.at(run, this.#plane, t, this.#pressed);
    if (this.#stacked) this.ledger?.at(t);
    put(need(this.root, ".carts-cursor"), "transform", `translate(${x} 0)`);
    this.#curves.forEach((curve, i) => {
      const y = g.valueY(this.#plane, valueAt(this.#times(run), curve.values, curve.slopes, t));
      const dot = this.#dots[i];
      if (dot) put(dot, "transform", `translate(${x} ${px(y)})`);
    });
  }

  get #signed() {
    return this.#pressed && this.quantity === "F";
  }

  get #stacked() {
    return this.#pressed && this.ledger !== null && this.ledger.entries.length > 0;
  }

  /** @param {Run} run @returns {ArrayLike<number>} s, of what is drawn */
  #times(run) {
    return this.#stacked ? (this.ledger?.times ?? []) : run.trajectory.t;
  }

  #toggle() {
    this.#pressed = !this.#pressed;
    this.button?.setAttribute("aria-pressed", String(this.#pressed));
    this.#name();
    this.root.dispatchEvent(new CustomEvent("carts-redraw", { bubbles: true }));
  }

  /** What is drawn now: a ledger that was asked for may still be on its way. */
  #name() {
    const [title, symbol, rest] = this.ledger
      ? [this.#stacked ? tr("Energy") : tr("Kinetic energy"), "E", tr(" in {unit}", { unit: "J" })]
      : this.#pressed
        ? [this.signedName, "F", tr(" in N, + is right")]
        : [this.name, "|F|", tr(" in {unit}", { unit: "N" })];
    const italic = Object.assign(document.createElement("i"), { textContent: symbol });
    need(this.root, ".carts-graph-name").replaceChildren(`${title} `, italic, rest);
  }

  /** @param {number} t */
  #draw(t) {
    const run = /** @type {Run} */ (this.#run);
    const { header } = run;
    this.#curves = this.#curvesOf(run);
    const behind = this.behind && !this.#stacked ? this.#curvesOf(this.behind) : [];
    const first = this.#first
      ? g.extent(this.#curvesOf(this.#first), this.#times(this.#first))
      : /** @type {[number, number]} */ ([0, 0]);
    const all = [
      g.extent(this.#curves, this.#times(run)),
      g.extent(behind, this.behind?.trajectory.t ?? []),
      g.reached(first, this.reach, this.#signed),
    ];
    const low = Math.min(...all.map((one) => one[0]));
    const high = Math.max(...all.map((one) => one[1]));
    this.#plane = g.planeFor([low, high], this.#window ?? [0, header.until]);
    drawAxes(this.root, this.#plane);
    const group = need(this.root, '[data-part="curves"]');
    fit(group, this.#curves.length, () => svg("path"));
    this.#curves.forEach((curve, i) => {
      const line = /** @type {Element} */ (group.children[i]);
      put(line, "class", `carts-curve carts-${curve.style}${curve.over ? " carts-over" : ""}`);
    });
    this.#lines(run);
    ghostCurves(this.plot, behind, this.behind?.trajectory.t ?? [], this.#plane);
    this.drawn(this, this.#plane);
    this.#cursor();
    if (this.#stacked) {
      this.ledger?.draw(this.#plane);
      this.key.forget();
    } else {
      this.ledger?.clear();
      const whole = this.#seen === Infinity; // else a note would tell what comes
      const note = whole ? graphNote(this.quantity, header.events, this.#curves.length) : "";
      this.key.show(this.#curves, (this.#pressed && this.ledger?.waits) || note);
    }
    if (this.ledger) this.#name();
    this.at(t);
  }

  /** The curves, up to what was seen. @param {Run} run */
  #lines(run) {
    const group = need(this.root, '[data-part="curves"]');
    this.#curves.forEach((curve, i) => {
      const line = /** @type {Element} */ (group.children[i]);
      put(line, "d", g.path(curve, this.#times(run), this.#plane, this.#seen));
    });
    const room = this.root.querySelector(".carts-seen rect"); // only where a run is watched first
    const end = Math.min(g.RIGHT, Math.max(g.LEFT, g.timeX(this.#plane, this.#seen)));
    if (room) put(room, "width", px(end - g.LEFT + 1));
  }

  /** @param {Run} run */
  #curvesOf({ header, trajectory }) {
    if (this.#stacked) return this.ledger?.tops ?? [];
    return seriesOf(this.quantity, header, trajectory, this.camera, this.#signed, this.per);
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
}
