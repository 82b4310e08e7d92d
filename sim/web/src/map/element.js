/** `<carts-map>`: a picture until the reader opens it; then Python, with numpy, computes it anew. */

import { told, tr } from "../../../view/language.js";
import { valueText } from "../../../view/map/words.js";
import { Controls } from "../scene/controls.js";
import { LIVE } from "../scene/element-words.js";
import { need, say } from "../shared/dom.js";
import { frame, waited } from "../shared/waiting.js";
import { AxisControl } from "./axis.js";
import { MapFigure } from "./figure.js";
import { Filling } from "./filling.js";
import { runPoint } from "./run-point.js";
import { offerOpening, showProgress, showSettings } from "./settings.js";
import { fillTable } from "./table.js";

/** @typedef {import("../../../view/map/types.js").MapFacts} MapFacts */
/** @typedef {import("../../../view/map/types.js").Grid} Grid */

/** The element class for a client. @param {import("../runtime/client.js").Client} client */
export function mapElement(client) {
  return class CartsMap extends HTMLElement {
    /** @type {MapFacts | null} */
    #facts = null;
    /** @type {MapFigure | null} */
    #figure = null;
    /** @type {AxisControl[]} */
    #axes = [];
    /** @type {Controls | null} */
    #controls = null;
    /** @type {Grid | null} */
    #grid = null;
    /** @type {number[]} the chosen point, one place per axis */
    #places = [];
    /** @type {Record<string, number | string>} what the further sliders set */
    #settings = {};
    /** @type {Promise<void> | null} */
    #opening = null;
    #filling = new Filling(
      (set, from) => client.ask(this, () => ({ kind: "map", map: this.#facts?.map, set, from })),
      {
        slice: (numbers) => this.#take(numbers),
        progress: (done, all) => showProgress(this, done, all),
        complete: (detail) => {
          showProgress(this, 1, 1);
          this.dispatchEvent(new CustomEvent("carts-update", { bubbles: true, detail }));
        },
        failed: (error) => this.#fail(error),
      },
    );

    #leaving = new AbortController(); // ends what it hears of the page

    connectedCallback() {
      this.#leaving = new AbortController();
      const { signal } = this.#leaving;
      addEventListener("beforeprint", () => this.#fillTable(), { signal });
      if (this.#facts) return;
      /** @type {MapFacts} */
      const facts = JSON.parse(need(this, ".carts-map-baked").textContent ?? "");
      this.#facts = facts;
      this.#places = facts.here;
      this.#figure = new MapFigure(this, facts, (places) => this.#choose(places));
      const roots = this.querySelectorAll(".carts-map-axis");
      this.#axes = facts.axes.map((axis, k) => {
        const root = /** @type {HTMLElement} */ (roots[k]);
        return new AxisControl(root, axis, (place) =>
          this.#choose(this.#places.map((old, other) => (other === k ? place : old))),
        );
      });
      this.#controls = new Controls(this, facts.controls, {
        change: (target, value, at) =>
          void this.set({ [target]: value }, at).catch((error) =>
            this.#controls?.complain(target, error.message),
          ),
      });
      this.#figure.mark(facts.here, facts.at ?? Number.NaN);
      offerOpening(this, true);
      need(this, ".carts-map-open").addEventListener("click", () => void this.open());
      this.querySelector(".carts-map-run")?.addEventListener("click", () => {
        const values = { ...this.#settings, ...this.point };
        void runPoint(facts.of ?? "", values, (message) => this.#tell(message));
      });
      need(this, ".carts-map-table").addEventListener("toggle", () => this.#fillTable());
    }

    disconnectedCallback() {
      this.#leaving.abort();
    }

    /** The grid that is shown: axes and values in SI, a row for each value of the second axis. */
    get grid() {
      return this.#grid;
    }

    /** The chosen point: SI values by path. @returns {Record<string, number>} */
    get point() {
      const chosen = this.#axes.map(({ axis, values }, k) => [
        axis.set,
        Number(values[Number(this.#places[k])]),
      ]);
      return Object.fromEntries(chosen);
    }

    /** The value at the chosen point, in SI; NaN where there is none. */
    get value() {
      return this.#valueAt(this.#places);
    }

    /** Resolves when no point is left to be run. */
    get complete() {
      return this.#filling.whole;
    }

    /** Resolves when the map is live; never rejects: a failure is told in the map, and it may be opened again. */
    open() {
      this.#opening ??= this.#open();
      return this.#opening;
    }

    /**
     * Changes what all points have in common and resolves when the new map is drawn.
     * @param {Record<string, number | string>} changes @param {number} at time of the input
     */
    async set(changes, at = performance.now()) {
      const settings = { ...this.#settings, ...changes };
      await this.#compute(settings, at);
    }

    async #open() {
      this.dataset.state = "starting";
      const button = /** @type {HTMLButtonElement} */ (need(this, ".carts-map-open"));
      button.disabled = true;
      this.#tell("");
      say(need(this, ".carts-map-wait"), tr("Python is being loaded for all points at once …"));
      try {
        await client.need(this.#facts?.packages ?? []);
        await this.#compute(this.#settings, performance.now());
        this.dataset.state = "live";
        need(this, ".carts-mark").setAttribute("aria-label", LIVE);
        const focused = button === document.activeElement;
        offerOpening(this, false);
        showProgress(this, 1, 1);
        for (const control of this.#axes) control.enable(true);
        this.#controls?.enable(true);
        const run = this.querySelector(".carts-map-run");
        if (run instanceof HTMLButtonElement) run.disabled = false;
        if (focused) this.#axes[0]?.slider.focus();
      } catch (error) {
        this.#fail(/** @type {Error & {reason?: string}} */ (error));
      }
    }

    /** @param {Error & {reason?: string}} error */
    #fail(error) {
      this.#opening = null;
      this.dataset.state = "failed";
      this.dataset.reason = error.reason ?? "failed";
      this.#tell(
        tr("{reason} The picture and the table stay as they were prepared.", {
          reason: error.message,
        }),
      );
      showProgress(this, 1, 1);
      say(need(this, ".carts-map-wait"), "");
      offerOpening(this, client.state !== "failed");
    }

    /** @param {string} message */
    #tell(message) {
      const note = need(this, ".carts-note");
      say(note, message);
      note.hidden = !message;
    }

    /** Asks for the whole map and draws it; what has to be run point by point comes afterwards. @param {Record<string, number | string>} settings @param {number} at */
    #compute(settings, at) {
      return this.#filling.map(settings, async ({ header, numbers }) => {
        this.#settings = settings;
        showSettings(this, this.#facts?.controls ?? [], settings);
        const { axes, rows, columns, why } = header;
        this.#draw({ axes, rows, columns, why, values: numbers });
        await frame();
        waited("carts:map", at);
      });
    }

    /** Some points, and behind them their values, drawn as they come. @param {Float64Array} numbers */
    #take(numbers) {
      if (!this.#grid) return;
      const half = numbers.length / 2;
      for (let k = 0; k < half; k += 1) {
        this.#grid.values[Number(numbers[k])] = Number(numbers[half + k]);
      }
      this.#draw(this.#grid);
    }

    /** @param {Grid} grid */
    #draw(grid) {
      const before = this.#grid?.axes;
      this.#grid = grid;
      this.#figure?.show(grid);
      if (before !== grid.axes) {
        const point = before ? this.point : null;
        this.#places = this.#axes.map((control, k) => {
          const { set, values } = control.axis; // baked: where the point stood in the page as it was built
          const wanted = point?.[set] ?? values[Number(this.#facts?.here[k])];
          control.show(grid.axes[k] ?? [], 0);
          return control.nearest(Number(wanted));
        });
      }
      this.#choose(this.#places);
      if (this.querySelector(".carts-map-table[open]")) this.#fillTable();
      say(need(this, ".carts-map-why"), told(grid.why));
    }

    /** @param {number[]} places */
    #choose(places) {
      if (!this.#grid) return;
      this.#places = places;
      const value = this.#valueAt(places);
      const facts = /** @type {MapFacts} */ (this.#facts);
      const number = valueText(value, facts);
      const text = Number.isNaN(value) ? number : `${number} ${facts.unit}`;
      for (const [k, control] of this.#axes.entries()) {
        control.show(this.#grid.axes[k] ?? [], Number(places[k]));
        control.speak(Number(places[k]), text);
      }
      this.#figure?.mark(places, value);
      say(need(this, ".carts-map-number"), text);
    }

    /** @param {number[]} places */
    #valueAt([column = 0, row = 0]) {
      return Number(this.#grid?.values[row * (this.#grid?.columns ?? 0) + column]);
    }

    #fillTable() {
      if (!this.#grid || !this.#facts) return;
      const axisText = (/** @type {number} */ k, /** @type {number} */ place) =>
        this.#axes[k]?.text(place) ?? "";
      fillTable(need(this, ".carts-map-table table"), this.#grid, axisText, this.#facts);
    }
  };
}
