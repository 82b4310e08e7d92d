/**
 * Everything that shows a run, as one: `show` a run, then `at` any instant. It fills the skeleton that
 * `sim/view/skeleton` writes, in the page and, for the first instant, when the site is built.
 */

import { dashed } from "../../../view/bodies.js";
import { actingSentences } from "../../../view/effects-words.js";
import { told, tr } from "../../../view/language.js";
import { fixed } from "../../../view/numbers.js";
import { isTold } from "../../../view/trajectory.js";
import { windowsOf } from "../../../view/windows.js";
import { html, need, put, say } from "../shared/dom.js";
import { Views } from "./beside/views.js";
import { GraphView } from "./graphs/graph-view.js";
import { Readouts } from "./readouts.js";
import { Stage } from "./stage.js";
import { Story } from "./story.js";
import { Timeline } from "./time/timeline.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/windows.js").Touch} Touch */

export class Drawing {
  /** @type {Run} */
  run;
  /** @type {Touch[]} bodies that touch in the run shown */
  windows = [];
  /** s, as far as the run may be drawn: what was not seen yet is nowhere on the page */
  #seen = Infinity;

  /**
   * @param {HTMLElement} root @param {import("../../../view/types.js").Baked} baked
   * @param {(t: number) => void} seek when the reader points at a time
   */
  constructor(root, baked, seek = () => {}) {
    this.root = root;
    this.baked = baked;
    this.run = baked.run;
    const stages = /** @type {NodeListOf<SVGElement>} */ (root.querySelectorAll(".carts-stage"));
    this.stages = [...stages].map((stage) => new Stage(stage, baked));
    const graphs = /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll(".carts-graph"));
    this.graphs = [...graphs].map((graph) => new GraphView(graph, baked, seek));
    this.views = new Views(root, baked);
    this.readouts = new Readouts(root, baked);
    this.timeline = new Timeline(root, seek);
    this.story = new Story(root, baked, seek);
    this.torn = root.querySelectorAll(".carts-torn");
    this.acting = root.querySelector(".carts-acting");
    this.warnings = need(root, ".carts-warnings");
    this.zoom = /** @type {HTMLSelectElement} */ (need(root, ".carts-window"));
  }

  /** Puts a run on the page. @param {Run} run @param {number} t the instant shown, in s */
  show(run, t) {
    this.run = run;
    this.windows = windowsOf(run);
    this.#words();
    this.stand();
    for (const graph of this.graphs) graph.show(run, t);
    this.views.show(run, this.windows, t);
    this.readouts.show(run);
    this.timeline.show(run, this.windows);
    this.story.show(run);
    this.#offerWindows();
  }

  /** Draws the run as far as it was watched. @param {number} seen in s */
  grow(seen) {
    if (seen === this.#seen) return;
    this.#seen = seen;
    for (const graph of this.graphs) graph.grow(seen);
    this.timeline.grow(seen);
    this.story.grow(seen);
    this.#offerWindows();
  }

  /** Draws the instant t. @param {number} t in s */
  at(t) {
    for (const stage of this.stages) stage.at(t);
    for (const graph of this.graphs) graph.at(t);
    this.views.at(t);
    this.readouts.at(t);
    this.timeline.at(t, tr("{time} seconds", { time: fixed(t, 2) }));
  }

  /** The carts with boxes for their masses. */
  stand() {
    for (const stage of this.stages) stage.show(this.run, this.windows);
    const torn = this.stages.some((stage) => stage.torn);
    for (const sign of this.torn) {
      if (torn) sign.removeAttribute("hidden"); // else it keeps its place where a slider may call for it
      put(sign, "data-now", torn ? "yes" : "no");
    }
  }

  /** What acts, and what a reader must know before anything moves. */
  #words() {
    const { header } = this.run;
    const numbers = isTold(this.run) && this.baked.fence.forces === "shown";
    if (this.acting) say(this.acting, actingSentences(header, numbers));
    this.warnings.hidden = header.warnings.length === 0;
    this.warnings.replaceChildren(
      ...header.warnings.map(({ message }) => html("p", "", told(message))),
    );
  }

  /** Parts of the time that the graphs can show alone: those in which bodies touch, as far as was seen. */
  #offerWindows() {
    const begun = this.windows.filter(({ start }) => start <= this.#seen);
    const texts = begun.map(({ bodies, start }) => {
      const names = dashed(bodies, this.run.header.track);
      return tr("{names} at {time} s", { names, time: fixed(start, 2) });
    });
    const whole = need(this.zoom, "option");
    const there = [...this.zoom.options].slice(1);
    if (there.map(({ text }) => text).join("\n") === texts.join("\n")) return;
    const chosen = this.zoom.selectedIndex;
    const options = texts.map((text, i) => {
      const option = html("option", "", text);
      option.setAttribute("value", String(i));
      return option;
    });
    this.zoom.replaceChildren(whole, ...options);
    this.zoom.selectedIndex = chosen <= options.length ? chosen : 0;
  }
}
