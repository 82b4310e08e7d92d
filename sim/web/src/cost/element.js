/** `<carts-cost>`: one scene run twice, by a stepping method and exactly; every method's error against its time. */

import { cells, rowOf, told } from "../../../view/cost/words.js";
import { fixed } from "../../../view/numbers.js";
import { LIVE } from "../scene/element-words.js";
import { Player } from "../scene/time/player.js";
import { need, say } from "../shared/dom.js";
import { refusal } from "../shared/waiting.js";
import { showWorking } from "../shared/working.js";
import { BreaksFigure } from "./breaks.js";
import { Choice } from "./choice.js";
import { CostFigure } from "./figure.js";
import { guessFirst } from "./guess.js";
import { measureAll, PACKAGES } from "./measuring.js";
import { CostStage } from "./stage.js";
import { fill } from "./table.js";
import * as words from "./words.js";

/** @typedef {import("../../../view/cost/figure.js").CostRow} CostRow */
/** @typedef {import("../../../view/cost/words.js").CostHeader} CostHeader */
/** @typedef {{header: CostHeader, numbers: ArrayLike<number>}} CostRun */
/**
 * @typedef {{rows: CostRow[], floor?: number, digits?: Record<string, number>, measured?: string}} Measured
 * @typedef {{breaks?: import("../../../view/cost/breaks.js").Breaks, scenes: Record<string, object>, untils: Record<string, number>, measured: Record<string, Measured>, run: CostRun}} CostFacts
 */

/** The element class for a client. @param {import("../runtime/client.js").Client} client */
export function costElement(client) {
  return class CartsCost extends HTMLElement {
    /** @type {CostFacts | null} */
    #facts = null;
    /** @type {CostRow[]} */
    rows = [];
    /** @type {CostRun | null} */
    run = null;
    /** Resolves when the newest measurement is complete or was stopped. @type {Promise<void>} */
    complete = Promise.resolve();
    choice = new Choice(this);
    #generation = 0;
    #measuring = 0;
    #forgetGuess = () => {};
    #fresh = 0; // rows of the newest measurement
    /** @type {CostStage | null} */
    #stage = null;
    /** @type {CostFigure | null} */
    #figure = null;
    /** @type {Player | null} */
    #player = null;

    connectedCallback() {
      if (this.#facts) return;
      /** @type {CostFacts} */
      const facts = JSON.parse(need(this, ".carts-cost-baked").textContent ?? "");
      this.#facts = facts;
      this.#stage = new CostStage(this);
      this.#figure = new CostFigure(this);
      this.#player = new Player(() => this.#frame());
      for (const part of ["scene", "method", "step", "rtol", "play", "scrub", "go"]) {
        /** @type {HTMLInputElement} */ (need(this, `.carts-cost-${part}`)).disabled = false;
      }
      const known = facts.measured[this.choice.scene];
      this.rows = known?.rows ?? [];
      this.#figure.floor = known?.floor;
      this.#show(facts.run);
      this.#mark();
      this.#forgetGuess = guessFirst(this, () => this.rows);
      if (facts.breaks) {
        new BreaksFigure(this, facts.breaks, (point) => {
          this.scrollIntoView();
          void this.compute(point);
        });
      }
      this.choice.follow(
        () => this.#newScene(),
        () => void this.compute(),
      );
      need(this, ".carts-cost-play").addEventListener("click", () => this.#player?.toggle());
      const scrub = /** @type {HTMLInputElement} */ (need(this, ".carts-cost-scrub"));
      scrub.addEventListener("input", () => {
        this.#player?.pause();
        this.#player?.seek(scrub.valueAsNumber);
      });
      need(this, ".carts-cost-go").addEventListener("click", () => void this.measure());
      need(this, ".carts-cost-stop").addEventListener("click", () => this.stop());
    }

    disconnectedCallback() {
      this.#player?.pause();
      this.stop();
    }

    get #scene() {
      return this.#facts?.scenes[this.choice.scene];
    }

    /** How long the chosen scene runs, in s; a point of the map may be shown instead. */
    get #until() {
      return Number(this.#facts?.untils[this.choice.scene]);
    }

    /**
     * Runs the chosen scene with the chosen method, or a point of the map; resolves when it is drawn.
     * @param {{scene: object, method: string, parts: number, told: string}} [point]
     */
    async compute(point) {
      this.#generation += 1;
      const generation = this.#generation;
      if (point) {
        this.choice.of("method").value = point.method;
        this.#note(words.POINT_RUNS);
      }
      const asked = this.choice.asked(point?.parts);
      try {
        if (this.choice.adaptive) {
          this.#note(words.LOADING);
          await client.need(PACKAGES);
          if (generation !== this.#generation) return;
        }
        const scene = point?.scene ?? this.#scene;
        const message = { kind: "cost", scene, ...asked };
        const { header, numbers } = await client.ask(this, () => message);
        if (generation !== this.#generation) return;
        if (!header.ok) throw refusal(header.problems ?? []);
        this.#live();
        this.#note(point ? words.fromMap(point.told) : "");
        this.#show({ header: /** @type {any} */ (header), numbers });
        if (!point) this.#mark();
        this.dispatchEvent(new CustomEvent("carts-update", { bubbles: true }));
      } catch (error) {
        if (generation === this.#generation) this.#fail(/** @type {Error} */ (error));
      }
    }

    measure() {
      this.complete = this.#measure();
      return this.complete;
    }

    /** Leaves a measurement where it is; what was measured stays. */
    stop() {
      if (!this.#measuring) return;
      this.#measuring = 0;
      showWorking(this, "cost", false);
      say(need(this, ".carts-cost-say"), words.stoppedWords(this.#fresh));
    }

    async #measure() {
      const turn = Math.random() + 1;
      this.#measuring = turn;
      this.#fresh = 0;
      showWorking(this, "cost", true);
      say(need(this, ".carts-cost-say"), words.LOADING_BOTH);
      const refused = new Map(); // what a method that cannot follow the scene says
      try {
        const done = await measureAll(client, this, this.#scene, {
          going: () => this.#measuring === turn,
          rows: (rows) => {
            this.#live();
            this.#rows(rows);
            this.#fresh = rows.length;
          },
          refused: (method, reason) => refused.set(method, reason),
          tell: (floor, digits) => this.#figure?.tell(floor, digits),
        });
        if (!done) return;
        this.#measuring = 0;
        say(need(this, ".carts-cost-say"), words.doneWords(refused));
      } catch (error) {
        this.#measuring = 0;
        this.#fail(/** @type {Error} */ (error));
        say(need(this, ".carts-cost-say"), "");
      } finally {
        if (this.#measuring === 0 || this.#measuring === turn) showWorking(this, "cost", false);
      }
    }

    /** Another scene: the measurements were those of the one before. */
    #newScene() {
      this.stop();
      this.#forgetGuess(); // it was of the other scene
      const known = this.#facts?.measured[this.choice.scene];
      this.#figure?.tell(known?.floor, known?.digits ?? {});
      this.#rows(known?.rows ?? []);
      say(need(this, ".carts-cost-say"), words.measuredWords(known?.measured));
      void this.compute();
    }

    /** @param {CostRow[]} rows */
    #rows(rows) {
      this.rows = [...rows];
      this.#figure?.show(rows);
      this.#mark();
      const lines = rows.map((row) => cells(row, this.#until));
      fill(need(this, ".carts-cost-table table"), lines);
    }

    /** The ring stands where the chosen method and step were measured. */
    #mark() {
      this.#figure?.mark(rowOf(this.rows, this.#until, this.choice.all));
    }

    /** @param {CostRun} run */
    #show(run) {
      this.run = run;
      this.#stage?.show(run.header, run.numbers);
      fill(need(this, ".carts-cost-told"), told(run.header));
      /** @type {HTMLInputElement} */ (need(this, ".carts-cost-scrub")).max = String(
        run.header.until,
      );
      if (!this.#player) return;
      this.#player.until = run.header.until;
      this.#player.speed = run.header.until / 4; // a run takes four seconds to watch
      this.#player.seek(this.#player.playing ? this.#player.time : run.header.until);
    }

    #frame() {
      const player = /** @type {Player} */ (this.#player);
      this.#stage?.at(player.time);
      this.classList.toggle("carts-is-playing", player.playing);
      say(need(this, ".carts-cost-play"), player.playing ? words.PAUSE : words.PLAY);
      /** @type {HTMLInputElement} */ (need(this, ".carts-cost-scrub")).valueAsNumber = player.time;
      say(need(this, ".carts-cost-clock"), `${fixed(player.time, 2)} s`);
    }

    #live() {
      this.dataset.state = "live";
      need(this, ".carts-mark").setAttribute("aria-label", LIVE);
    }

    /** @param {Error & {reason?: string}} error */
    #fail(error) {
      this.dataset.reason = error.reason ?? "failed";
      this.#note(words.keptWords(error.message));
    }

    /** @param {string} message */
    #note(message) {
      const note = need(this, ".carts-note");
      say(note, message);
      note.hidden = !message;
    }
  };
}
