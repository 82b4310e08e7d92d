/** A scene that a reader plays: its drawing, its time, and what the reader chooses to see. */

import { marks } from "../../../view/effects-words.js";
import { isTold } from "../../../view/trajectory.js";
import { need } from "../shared/dom.js";
import { Announcer } from "./announcer.js";
import { Described } from "./described.js";
import { Drag } from "./drag.js";
import { Drawing } from "./drawing.js";
import { Choose, emptyGraph } from "./graphs/choose.js";
import { GraphView } from "./graphs/graph-view.js";
import { Ghost } from "./how/ghost.js";
import { Player } from "./time/player.js";
import { slowParts } from "./time/slow.js";
import { Sound } from "./time/sound.js";
import { Transport } from "./time/transport.js";

/** @typedef {import("../../../view/types.js").Run} Run */

const HALTS = new Set(["contact", "peak", "separate", "stick", "release"]);

export class SceneView {
  /** @type {Run | null} another run, seen pale behind the one that is shown */
  behind = null;
  /** @type {GraphView["drawn"]} */
  #drawn = () => {};

  /** @param {HTMLElement} root @param {import("../../../view/types.js").Baked} baked */
  constructor(root, baked) {
    this.root = root;
    this.baked = baked;
    this.player = new Player((before, forward) => this.#moved(before, forward));
    this.player.halting = baked.fence.slow === "stops";
    this.seek = (/** @type {number} */ t) => {
      this.player.pause();
      this.player.seek(t);
    };
    this.drawing = new Drawing(root, baked, this.seek);
    this.ghosts = this.drawing.stages.map((stage) => new Ghost(stage));
    this.sound = new Sound();
    this.#offerChoices();
    this.transport = new Transport(root, this.player, baked.view.decimals);
    this.announcer = new Announcer(root);
    this.described = new Described(root, baked);
    this.player.stepped = (before) => this.#stepped(before);
    this.drawing.zoom.addEventListener("change", () => this.#zoom());
    for (const summary of root.querySelectorAll(".carts-model > summary, .carts-how > summary")) {
      // The theme opens every box for paper: only what a reader has opened is printed.
      summary.addEventListener("click", () =>
        summary.parentElement?.setAttribute("data-reader", ""),
      );
    }
    need(root, ".carts-frame").addEventListener("carts-redraw", () => {
      for (const graph of this.drawing.graphs) graph.show(this.run, this.player.time);
    });
  }

  get run() {
    return this.drawing.run;
  }

  get stages() {
    return this.drawing.stages;
  }

  /** @returns {{run: Run, t: number, quantities: string[], seen: number}} what is seen */
  get now() {
    const quantities = this.drawing.graphs.map((graph) => graph.quantity);
    const { time: t, seen } = this.player;
    return { run: this.run, t, quantities, seen };
  }

  /**
   * Puts a run on the page, at the time that is shown now.
   * @param {Run} run @param {Run | null} behind another run, seen pale behind it
   */
  show(run, behind = null) {
    const { header } = run;
    this.behind = behind;
    for (const ghost of this.ghosts) ghost.show(behind);
    for (const graph of this.drawing.graphs) graph.behind = behind;
    if (this.player.seen < Infinity) this.player.seen = this.player.time; // another run: not seen yet
    this.drawing.grow(this.player.seen);
    this.drawing.show(run, this.player.time);
    this.player.until = header.until;
    this.player.parts = slowParts(this.drawing.windows);
    const pushes = isTold(run) ? marks(header, false) : [];
    this.player.stops = [...header.events, ...pushes].map(({ t }) => t).sort((a, b) => a - b);
    this.player.halts = header.events.filter(({ kind }) => HALTS.has(kind)).map(({ t }) => t);
    this.#zoom();
    this.player.seek(this.player.time);
  }

  /** Every graph is drawn anew, and with it what `drawn` adds. @param {GraphView["drawn"]} drawn */
  redraw(drawn) {
    this.#drawn = drawn;
    for (const graph of this.drawing.graphs) {
      graph.drawn = drawn;
      graph.show(this.run, this.player.time);
    }
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
    if (on) for (const graph of this.drawing.graphs) graph.enable();
  }

  /** Fills and opens the tables for paper. @param {boolean} open */
  print(open) {
    for (const { table } of this.drawing.graphs) {
      const { details } = table;
      if (open && !details.open) details.dataset.printed = ""; // to be closed again
      if (open || "printed" in details.dataset) details.open = open;
      if (!open) delete details.dataset.printed;
      table.fill();
    }
  }

  /** @param {number} before @param {boolean} forward */
  #moved(before, forward) {
    const t = this.player.time;
    this.drawing.grow(this.player.seen);
    this.drawing.at(t);
    for (const ghost of this.ghosts) ghost.at(t);
    this.transport.show();
    this.described.at(this.run, t, this.player.playing);
    if (!forward || t === before) return;
    this.announcer.tell(this.drawing.story.between(before, t));
    this.sound.between(this.run.header.events, before, t);
  }

  /** Says what a step led to. @param {number} before in s */
  #stepped(before) {
    const t = this.player.time;
    const events = t > before ? this.drawing.story.between(before, t) : [];
    if (t !== before) this.announcer.tell([...events, this.described.words(this.run, t)]);
  }

  #offerChoices() {
    const { views } = this.drawing;
    const now = { stills: this.player.stills, sound: this.sound.on };
    new Choose(this.root, this.baked, views.choices, now, {
      graph: (quantity, seen) => this.#chooseGraph(quantity, seen),
      view: (key, seen) => views.choose(key, seen),
      areas: (on) => {
        this.baked.view.alike = !on;
        this.drawing.stand();
        this.player.seek(this.player.time);
      },
      playing: (key, on) => {
        if (key === "sound") this.sound.set(on);
        else this.player[key === "stills" ? "stills" : "halting"] = on;
      },
    });
  }

  /** @param {string} quantity @param {boolean} seen */
  #chooseGraph(quantity, seen) {
    const place = need(this.root, ".carts-graphs");
    const { graphs } = this.drawing;
    const there = graphs.find((graph) => graph.quantity === quantity);
    if (!seen && there) {
      this.drawing.graphs = graphs.filter((graph) => graph !== there);
      there.root.remove();
    }
    if (!seen || there) return;
    const graph = new GraphView(emptyGraph(this.baked, quantity), this.baked, this.seek);
    place.insertBefore(graph.root, need(place, ".carts-story"));
    graphs.push(graph);
    graph.enable();
    graph.behind = this.behind;
    graph.drawn = this.#drawn;
    graph.grow(this.player.seen);
    graph.show(this.run, this.player.time);
    this.#zoom();
  }

  /** The time axis of the graphs: all of the run, or the touch that the reader chose. */
  #zoom() {
    const { zoom, windows, graphs } = this.drawing;
    const touch = zoom.value ? windows[Number(zoom.value)] : undefined;
    const room = touch ? 0.3 * (touch.end - touch.start) : 0;
    /** @type {[number, number] | null} */
    const window = touch
      ? [Math.max(0, touch.start - room), Math.min(this.run.header.until, touch.end + room)]
      : null;
    for (const graph of graphs) graph.zoom(window, this.player.time);
  }
}
