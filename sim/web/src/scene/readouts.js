/** Numbers of each cart at the instant shown. */

import { resultant } from "../../../view/forces.js";
import { fixed, NOISE, short, speedUnit } from "../../../view/numbers.js";
import { isTold, valueAt } from "../../../view/trajectory.js";
import { need, say } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Run} Run */

export class Readouts {
  /** @type {Run | null} */
  #run = null;

  /** @param {HTMLElement} root @param {import("../../../view/types.js").Baked} baked */
  constructor(root, baked) {
    this.camera = baked.fence.camera;
    this.decimals = baked.view.decimals;
    this.per = speedUnit(baked.view.velocity)[0];
    this.zero = NOISE * (baked.view.force || 1);
    /** @type {{name: string, outputs: Map<string, Element>}[]} */
    this.cards = baked.run.header.bodies.map(({ name }) => {
      const card = need(root, `.carts-card[data-body="${name}"]`);
      const outputs = /** @type {NodeListOf<HTMLElement>} */ (
        card.querySelectorAll(".carts-value")
      );
      return { name, outputs: new Map([...outputs].map((o) => [o.dataset.quantity ?? "", o])) };
    });
  }

  /** @param {Run} run */
  show(run) {
    this.#run = run;
  }

  /** @param {number} t in s */
  at(t) {
    const run = this.#run;
    if (!run) return;
    const { t: times, x, v, a } = run.trajectory;
    const told = isTold(run);
    for (const { name, outputs } of this.cards) {
      const mass = run.header.bodies.find((body) => body.name === name)?.mass ?? 0;
      const force = told ? resultant(run, name, t, this.zero) : null;
      /** @type {Map<string, number | null>} null: not told before the lock */
      const values = new Map([
        ["x", valueAt(times, x[name] ?? [], v[name] ?? [], t) - this.camera * t],
        ["v", (valueAt(times, v[name] ?? [], a[name] ?? [], t) - this.camera) / this.per],
        ["F", force],
        ["a", force === null ? null : force / mass],
      ]);
      for (const [quantity, output] of outputs) {
        if (quantity === "mass") {
          say(output, short(mass));
          continue;
        }
        const value = values.get(quantity) ?? null;
        const decimals = this.decimals[quantity] ?? 3;
        say(output, value === null ? "–" : fixed(value, decimals));
      }
    }
  }
}
