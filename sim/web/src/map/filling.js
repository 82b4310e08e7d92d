/**
 * Asks Python for a map: all of it at once, and what has to be run point by point slice after slice. A newer
 * map takes the place of the one that is being filled; one that is refused does not.
 */

import { refusal } from "../shared/waiting.js";

/** @typedef {Record<string, number | string>} Settings */
/** @typedef {{header: any, numbers: Float64Array}} Reply */
/** @typedef {{settings: Settings, done: number, runs: number}} Rest what is left of the map that is shown */

export class Filling {
  #turn = 0;
  /** @type {Rest | null} */
  #rest = null;
  #filled = Promise.resolve();
  /** Resolves when no point is left to be run. */
  whole = Promise.resolve();

  /**
   * @param {(settings: Settings, from: number) => Promise<Reply>} ask
   * @param {{slice: (numbers: Float64Array) => void, progress: (done: number, all: number) => void,
   *   complete: (settings: Settings) => void, failed: (error: Error) => void}} acts
   */
  constructor(ask, acts) {
    this.ask = ask;
    this.acts = acts;
  }

  /** Resolves when the map is drawn, or a newer one was asked for. @param {Settings} settings @param {(first: Reply) => Promise<void>} draw */
  map(settings, draw) {
    const drawn = this.#map(settings, draw);
    this.whole = drawn.catch(() => {}).then(() => this.#filled);
    return drawn;
  }

  /** @param {Settings} settings @param {(first: Reply) => Promise<void>} draw */
  async #map(settings, draw) {
    this.#turn += 1;
    const turn = this.#turn;
    try {
      const first = await this.ask(settings, 0);
      if (turn !== this.#turn) return;
      const { ok, problems, done, runs } = first.header;
      if (!ok) throw refusal(problems ?? []);
      this.#rest = { settings, done, runs };
      await draw(first);
    } finally {
      // Of a map that was refused, the one that is shown goes on.
      if (turn === this.#turn && this.#rest) this.#filled = this.#fill(this.#rest, turn);
    }
  }

  /** @param {Rest} rest @param {number} turn */
  async #fill(rest, turn) {
    try {
      while (rest.done < rest.runs) {
        this.acts.progress(rest.done, rest.runs);
        const { header, numbers } = await this.ask(rest.settings, rest.done);
        if (turn !== this.#turn) return this.whole;
        if (!header.ok) throw refusal(header.problems ?? []);
        this.acts.slice(numbers);
        rest.done = header.done;
      }
      this.#rest = null;
      this.acts.complete(rest.settings);
    } catch (error) {
      if (turn !== this.#turn) return this.whole;
      this.acts.failed(/** @type {Error} */ (error));
    }
  }
}
