/** The runs that a reader asks for: values go to Python, a run comes back. */

import { fromWire } from "../../../view/trajectory.js";
import { drawn, refusal } from "../shared/waiting.js";
import { Values } from "./values.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("./values.js").Settings} Settings */

export class Runs {
  values = new Values();
  #generation = 0; // of resets: what was asked for before one is not shown after it

  /**
   * @param {HTMLElement} owner whose newest request counts @param {import("../runtime/client.js").Client} client
   * @param {{scene: () => object | undefined, draw: (run: Run) => unknown, say: (message: string) => void}} acts
   *   `scene` as its author wrote it; `draw` resolves when the run is on the page; `say`: a message for the reader
   */
  constructor(owner, client, acts) {
    this.owner = owner;
    this.client = client;
    this.acts = acts;
  }

  /** Draws the run of changed values. @param {Settings} changes to be given up if they are refused @param {number} at time of the input, for the measure */
  async compute(changes, at) {
    const run = await this.ask(changes);
    if (!run) return;
    await this.acts.draw(run);
    await drawn(this.owner, at, { ...this.values.good });
  }

  undo() {
    this.values.undo();
    this.compute({}, performance.now()).catch((error) => this.acts.say(error.message));
  }

  /** Several values at once, from the scene as the lesson has it. @param {Settings} changes */
  preset(changes) {
    this.values.replace(changes);
    this.compute(changes, performance.now()).catch((error) => this.acts.say(error.message));
  }

  /** The run of the values asked for; null where they were reset meanwhile. Rejects with what a reader can do. @param {Settings} changes given up if they are refused @returns {Promise<Run | null>} */
  async ask(changes = {}) {
    const generation = this.#generation;
    const { header, numbers, sent } = await this.client.ask(this.owner, () => {
      return { kind: "run", scene: this.acts.scene(), set: { ...this.values.wanted } };
    });
    if (!header.ok) {
      this.values.giveUp(changes);
      throw refusal(header.problems ?? []);
    }
    if (generation !== this.#generation) return null;
    this.values.good = sent.set;
    return { header, trajectory: fromWire(header, numbers) };
  }

  /** Back to the values that the scene came with. */
  reset() {
    this.#generation += 1;
    this.values.reset();
  }
}
