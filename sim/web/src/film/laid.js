/** What was followed as readings, and the model that is laid over the film. */

import { Along, readings } from "./along.js";
import { crosses, marked, NAMES } from "./over.js";

/** @typedef {{name: string, text: string, clock: string}} Told readings as a file has them; `clock`: what their times are counted by */

export class Laid {
  /** @type {Along | null} */
  #along = null;
  #time = 0; // s of the readings, where the model is
  /** m @type {Record<string, number>} */
  #places = {};

  /** @param {import("./mending.js").Mending} mending @param {import("./setup.js").Setup} setup */
  constructor(mending, setup) {
    this.mending = mending;
    this.setup = setup;
  }

  /** @param {string} film its name @returns {Told | null} null: how long the ruler is, or how slow the film, is not known */
  read(film) {
    const { ruler, slower } = this.setup;
    const { rows } = this.mending;
    if (!ruler) return null;
    this.#along = new Along(rows, ruler);
    this.#places = {};
    const remarks = [`Newton's Carts, from the film ${film.replace(/\s+/g, " ")}`];
    return {
      name: `${film.replace(/\.\w+$/, "")}.csv`,
      text: readings(rows, ruler, { names: NAMES, slower, remarks }),
      clock: `${rows[0]?.t} ${slower}`,
    };
  }

  /** @param {number} time s of the readings @returns {number} of the film */
  filmed(time) {
    return (this.mending.rows[0]?.t ?? 0) + time * this.setup.slower;
  }

  /** The model is here now. @param {number} time s of the readings @param {Record<string, number>} places m @returns {boolean} whether it moved in time */
  at(time, places) {
    const moved = time !== this.#time;
    this.#time = time;
    this.#places = places;
    return moved;
  }

  /** What is drawn over the frame of this time. @param {number} time s of the film */
  marks(time) {
    const { rows } = this.mending;
    const row = rows[this.mending.at(time)] ?? null;
    const meant = rows[this.mending.at(this.filmed(this.#time))];
    const places = row === meant ? this.#places : {}; // of this frame only
    return [...marked(this.setup.points, row), ...crosses(places, this.#along, rows)];
  }
}
