/** Everything that shows a run, as one: `show` a run, then `at` any instant. */

import { actingSentences, pushMarks } from "../../../view/effects-words.js";
import { heard, tr } from "../../../view/language.js";
import { fixed } from "../../../view/numbers.js";
import { isTold } from "../../../view/trajectory.js";
import { touches } from "../../../view/windows.js";
import { brief } from "../../../view/words.js";
import { html, need, put, say } from "../shared/dom.js";
import { Announcer } from "./announcer.js";
import { Views } from "./beside/views.js";
import { Drag } from "./drag.js";
import { Choose, emptyGraph } from "./graphs/choose.js";
import { GraphView } from "./graphs/graph-view.js";
import { Ghost } from "./how/ghost.js";
import { Player } from "./player.js";
import { Readouts } from "./readouts.js";
import { slowParts } from "./slow.js";
import { Stage } from "./stage.js";
import { Story } from "./story.js";
import { Timeline } from "./timeline.js";
import { Transport } from "./transport.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/windows.js").Touch} Touch */

const HALTS = new Set(["contact", "peak", "separate", "stick", "release"]);

export class SceneView {
  /** @type {Run} */
  run;
  /** @type {Touch[]} */
  #windows = [];
  /** @type {Run | null} */
  behind = null;

  /** @param {HTMLElement} root @param {import("../../../view/types.js").Baked} baked */
  constructor(root, baked) {
    this.root = root;
    this.baked = baked;
    this.run = baked.run;
    this.player = new Player((before, forward) => this.#moved(before, forward));
    const seek = (/** @type {number} */ t) => {
      this.player.pause();
      this.player.seek(t);
    };
    const stages = /** @type {NodeListOf<SVGElement>} */ (root.querySelectorAll(".carts-stage"));
    this.stages = [...stages].map((stage) => new Stage(stage, baked));
    this.ghosts = this.stages.map((stage) => new Ghost(stage));
    this.player.halting = baked.fence.slow === "stops";
    this.seek = seek;
    const graphs = /** @type {NodeListOf<HTMLElement>} */ (root.querySelectorAll(".carts-graph"));
    this.graphs = [...graphs].map((graph) => new GraphView(graph, baked, seek));
    this.views = new Views(root, baked);
    new Choose(root, baked, this.views.choices, this.player.stills, {
      graph: (quantity, seen) => this.#chooseGraph(quantity, seen),
      view: (key, seen) => this.views.choose(key, seen),
      areas: (on) => {
        baked.view.alike = !on;
        for (const stage of this.stages) stage.show(this.run, this.#windows);
        this.#tellTorn();
        this.player.seek(this.player.time);
      },
      playing: (key, on) => {
        this.player[key === "stills" ? "stills" : "halting"] = on;
      },
    });
    this.readouts = new Readouts(root, baked);
    this.timeline = new Timeline(root, seek);
    this.story = new Story(root, baked, seek);
    this.transport = new Transport(root, this.player, baked.view.decimals);
    this.announcer = new Announcer(root);
    this.torn = root.querySelectorAll(".carts-torn");
    this.warnings = need(root, ".carts-warnings");
    this.zoom = /** @type {HTMLSelectElement | null} */ (root.querySelector(".carts-window"));
    this.zoom?.addEventListener("change", () => this.#zoom());
    root.addEventListener("carts-redraw", () => {
      for (const graph of this.graphs) graph.show(this.run, this.player.time);
    });
  }

  /** @returns {{run: Run, t: number, quantities: string[]}} what is seen */
  get now() {
    const quantities = this.graphs.map((graph) => graph.quantity);
    return { run: this.run, t: this.player.time, quantities };
  }

  /**
   * Puts a run on the page, at the time that is shown now.
   * @param {Run} run @param {Run | null} behind another run, seen pale behind it
   */
  show(run, behind = null) {
    this.run = run;
    this.behind = behind;
    for (const ghost of this.ghosts) ghost.show(behind);
    for (const graph of this.graphs) graph.behind = behind;
    const { header } = run;
    this.#windows = touches(header.events, header.until);
    this.player.until = header.until;
    this.player.parts = slowParts(this.#windows);
    const pushes = isTold(run) ? pushMarks(header, false) : [];
    this.player.stops = [...header.events, ...pushes].map(({ t }) => t).sort((a, b) => a - b);
    const acting = this.root.querySelector(".carts-acting");
    const numbers = isTold(run) && this.baked.fence.forces === "shown";
    if (acting) say(acting, actingSentences(header, numbers));
    this.player.halts = header.events.filter(({ kind }) => HALTS.has(kind)).map(({ t }) => t);
    this.#offerWindows();
    for (const stage of this.stages) stage.show(run, this.#windows);
    this.#tellTorn();
    for (const graph of this.graphs) graph.show(run, this.player.time);
    this.views.show(run, this.#windows, this.player.time);
    this.readouts.show(run);
    this.timeline.show(run, this.#windows);
    this.story.show(run);
    this.#warn();
    this.player.seek(this.player.time);
  }

  /** Lets the reader pull carts and velocity arrows. @param {ConstructorParameters<typeof Drag>[3]} acts */
  draggable(acts) {
    for (const stage of this.stages) new Drag(stage.root, stage.layout, this.baked, acts);
  }

  /** Lets the reader move the time. @param {boolean} on */
  enable(on) {
    const parts =
      ".carts-reset, .carts-preset, .carts-transport button, .carts-transport select, .carts-transport input, .carts-scrub, .carts-window";
    for (const part of this.root.querySelectorAll(parts)) {
      /** @type {HTMLButtonElement} */ (part).disabled = !on;
    }
    if (on) for (const graph of this.graphs) graph.enable();
  }

  /** Fills and opens the tables for paper. @param {boolean} open */
  print(open) {
    for (const { table } of this.graphs) {
      table.fill();
      table.details.open = open;
    }
  }

  /** @param {number} before @param {boolean} forward */
  #moved(before, forward) {
    const t = this.player.time;
    for (const stage of this.stages) stage.at(t);
    for (const ghost of this.ghosts) ghost.at(t);
    for (const graph of this.graphs) graph.at(t);
    this.views.at(t);
    this.readouts.at(t);
    this.timeline.at(t, tr("{time} seconds", { time: fixed(t, 2) }));
    this.transport.show();
    if (forward && t !== before) this.announcer.tell(this.story.between(before, t));
  }

  /** @param {string} quantity @param {boolean} seen */
  #chooseGraph(quantity, seen) {
    const place = need(this.root, ".carts-graphs");
    const there = this.graphs.find((graph) => graph.quantity === quantity);
    if (!seen && there) {
      this.graphs = this.graphs.filter((graph) => graph !== there);
      there.root.remove();
    }
    if (!seen || there) return;
    const graph = new GraphView(emptyGraph(this.baked, quantity), this.baked, this.seek);
    place.insertBefore(graph.root, need(place, ".carts-story"));
    this.graphs.push(graph);
    graph.enable();
    graph.behind = this.behind;
    graph.show(this.run, this.player.time);
    this.#zoom();
  }

  #tellTorn() {
    const torn = this.stages.some((stage) => stage.torn);
    for (const sign of this.torn) {
      if (torn) sign.removeAttribute("hidden"); // else it keeps its place where a slider may call for it
      put(sign, "data-now", torn ? "yes" : "no");
    }
  }

  #warn() {
    const { warnings } = this.run.header;
    this.warnings.hidden = warnings.length === 0;
    this.warnings.replaceChildren(...warnings.map(({ message }) => html("p", "", heard(message))));
  }

  #offerWindows() {
    if (!this.zoom) return;
    const chosen = this.zoom.selectedIndex;
    const options = this.#windows.map(({ bodies, start }, i) => {
      const names = bodies.map(brief).join("–");
      const option = html(
        "option",
        "",
        tr("{names} at {time} s", { names, time: fixed(start, 2) }),
      );
      option.setAttribute("value", String(i));
      return option;
    });
    while (this.zoom.options.length > 1) this.zoom.remove(1);
    this.zoom.append(...options);
    this.zoom.selectedIndex = chosen <= this.#windows.length ? chosen : 0;
    this.#zoom();
  }

  #zoom() {
    const touch = this.zoom?.value ? this.#windows[Number(this.zoom.value)] : undefined;
    const room = touch ? 0.3 * (touch.end - touch.start) : 0;
    /** @type {[number, number] | null} */
    const window = touch
      ? [Math.max(0, touch.start - room), Math.min(this.run.header.until, touch.end + room)]
      : null;
    for (const graph of this.graphs) graph.zoom(window, this.player.time);
  }
}
