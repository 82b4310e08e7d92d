/** The runs that a reader asks for: values go to Python, a run comes back. */

import { fromWire } from "../../../view/trajectory.js";
import { refusal } from "../shared/waiting.js";
import { Values } from "./values.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("./values.js").Settings} Settings */

export class Runs {
  values = new Values();
  #generation = 0; // of resets: what was asked for before one is not shown after it

  /** @param {object} owner whose newest request counts @param {import("../runtime/client.js").Client} client @param {() => object | undefined} scene as its author wrote it */
  constructor(owner, client, scene) {
    this.owner = owner;
    this.client = client;
    this.scene = scene;
  }

  /** The run of the values asked for; null where they were reset meanwhile. Rejects with what a reader can do. @param {Settings} changes given up if they are refused @returns {Promise<Run | null>} */
  async ask(changes = {}) {
    const generation = this.#generation;
    const { header, numbers, sent } = await this.client.ask(this.owner, () => {
      return { kind: "run", scene: this.scene(), set: { ...this.values.wanted } };
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
