/**
 * The runs that a reader asks for: values go to Python, a run comes back. While Python starts, the
 * nearest run that was prepared is shown meanwhile; where it cannot start, those are the runs.
 */

import { fromWire } from "../../../view/trajectory.js";
import { SLOW_AFTER, watch } from "../runtime/watch.js";
import { ASKED } from "../shared/ask-scene.js";
import { drawn, RESET, refusal } from "../shared/waiting.js";
import { Values } from "./values.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("./values.js").Settings} Settings */

export class Runs {
  values = new Values();
  /** @type {import("./prepared.js").Prepared | null} */
  prepared = null;
  #generation = 0; // of resets: what was asked for before one is not shown after it
  #changes = 0; // and resets so far: a prepared run is shown for the newest only, and before the exact one

  /**
   * @param {HTMLElement} owner whose newest request counts
   * @param {import("../runtime/client.js").Client} client
   * @param {{scene: () => object | undefined, draw: (run: Run) => unknown, say: (message: string) => void,
   *   long: (on: boolean) => void}} acts
   *   `scene` as its author wrote it; `draw` resolves when the run is on the page;
   *   `say`: a message for the reader; `long`: whether Python needs long
   */
  constructor(owner, client, acts) {
    this.owner = owner;
    this.client = client;
    this.acts = acts;
  }

  /**
   * Answers requests of other elements about this scene, with the accepted values.
   * @param {AbortSignal} signal
   */
  answerOthers(signal) {
    const owner = {}; // who asks: apart from the requests for runs
    const answer = (/** @type {any} */ { detail }) => {
      const asked = { scene: this.acts.scene(), set: { ...this.values.good }, ...detail.message };
      detail.answer(this.client.ask(owner, () => asked));
    };
    this.owner.addEventListener(ASKED, answer, { signal });
  }

  /** Whether there are runs that need no Python. */
  get stepwise() {
    return Boolean(this.prepared?.there);
  }

  /** Whether a changed value has an answer: of Python, or prepared. */
  get able() {
    return this.client.state !== "failed" || this.stepwise;
  }

  /** The values that a slider can take where there is no Python. @param {string} target @returns {number[] | undefined} in its unit */
  stops(target) {
    return this.client.state === "failed" ? this.prepared?.stops[target] : undefined;
  }

  /**
   * Draws the run of changed values.
   * @param {Settings} changes to be given up if they are refused
   * @param {number} at time of the input, for the measure
   */
  async compute(changes, at) {
    this.#changes += 1;
    if (this.client.state === "idle" || this.client.state === "starting") void this.#meanwhile();
    const run = await this.ask(changes);
    if (!run) return;
    this.#changes += 1;
    await this.acts.draw(run);
    await drawn(this.owner, at, { ...this.values.good });
  }

  undo() {
    this.values.undo();
    this.compute({}, performance.now()).catch((error) => this.acts.say(error.message));
  }

  /**
   * Several values at once, from the scene as the lesson has it.
   * @param {Settings} changes
   * @returns {Promise<boolean>} whether their run is on the page
   */
  preset(changes) {
    return this.become(changes).then(
      () => true,
      (error) => {
        this.acts.say(error.message);
        return false;
      },
    );
  }

  /**
   * These values in the place of all; where they are refused, it rejects and all is as it was.
   * @param {Settings} changes
   */
  become(changes) {
    const back = this.values.replace(changes);
    const done = this.compute(changes, performance.now());
    const newest = this.#changes;
    return done.catch((error) => {
      if (newest === this.#changes) back();
      throw error;
    });
  }

  /**
   * The run of the values asked for; null where they were reset meanwhile. Rejects with what a
   * reader can do.
   * @param {Settings} changes given up if they are refused
   * @returns {Promise<Run | null>}
   */
  async ask(changes = {}) {
    const generation = this.#generation;
    const { header, numbers, set } = await this.#answer().catch((error) => {
      this.values.giveUp(changes);
      throw error;
    });
    if (!header.ok) {
      this.values.giveUp(changes);
      throw refusal(header.problems ?? []);
    }
    if (generation !== this.#generation) return null;
    this.values.good = set;
    if (this.client.state === "failed") this.values.wanted = { ...set };
    return { header, trajectory: fromWire(header, numbers) };
  }

  /** Python's answer, or where it has failed the nearest of the prepared runs. */
  async #answer() {
    let long = false;
    const clock = watch(SLOW_AFTER, () => {
      long = this.client.state === "ready"; // what a start waits for is told by others
      if (long) this.acts.long(true);
    });
    try {
      const { header, numbers, sent } = await this.client.ask(this.owner, () => {
        return { kind: "run", scene: this.acts.scene(), set: { ...this.values.wanted } };
      });
      return { header, numbers, set: sent.set };
    } catch (error) {
      if (this.client.state !== "failed" || !this.prepared?.there) throw error;
      return this.prepared.nearest(this.values.wanted);
    } finally {
      clock.stop();
      if (long) this.acts.long(false);
    }
  }

  /** Shows the nearest prepared run if nothing newer has come before it. */
  async #meanwhile() {
    if (!this.prepared?.there) return;
    const newest = this.#changes;
    const found = await this.prepared.nearest(this.values.wanted).catch(() => null); // Python will say
    if (!found?.header.ok || newest !== this.#changes) return;
    this.values.good = found.set;
    const { header, numbers } = found;
    await this.acts.draw({ header, trajectory: fromWire(header, numbers) });
  }

  /** Back to the values that the scene came with. */
  reset() {
    this.#generation += 1;
    this.#changes += 1;
    this.values.reset();
    this.owner.dispatchEvent(new Event(RESET, { bubbles: true }));
  }
}
