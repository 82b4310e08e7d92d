/** Sets lost places by hand, one click each: goes to the next, where it is expected, until none is left. */

import { fixed } from "../../../view/numbers.js";
import { NAMES } from "./over.js";
import * as words from "./words.js";

/** @typedef {import("./along.js").Point} Point */
/** @typedef {import("./mending.js").Place} Place */
/**
 * @typedef {object} Film what it needs of the film in the page
 * @property {import("./setup.js").Setup} setup
 * @property {import("./view.js").View} view
 * @property {import("./frames.js").Frames} frames
 * @property {(text: string) => void} say
 * @property {() => void} changed places are others now
 * @property {() => void} read
 */

export class Repair {
  /** The place whose frame is on its way: nothing is set or left out in the frame that still stands there. @type {Place | null} */
  #going = null;

  /** @param {import("./mending.js").Mending} mending @param {Film} film */
  constructor(mending, film) {
    this.mending = mending;
    this.film = film;
  }

  /** @returns {Place} that a click would set now */
  get here() {
    const mark = Math.max(0, NAMES.indexOf(this.film.setup.aim));
    return { row: this.mending.at(this.film.frames.time), mark };
  }

  /** Goes to the next place that was lost. */
  next() {
    const found = this.mending.after(this.#going ?? this.here);
    if (found) this.#go(found);
    else this.film.say(words.noneLost());
  }

  /** @param {Place} place */
  #go(place) {
    this.#going = place;
    const t = this.mending.rows[place.row]?.t ?? 0;
    const { setup, frames, view, say, changed } = this.film;
    setup.aim = /** @type {"A"} */ (NAMES[place.mark]);
    setup.show();
    changed();
    view.reveal();
    say(words.clickLost(setup.aim, fixed(t, 3)));
    const expected = this.mending.expected(place);
    void frames.want(t + 1e-6).then(() => {
      if (this.#going !== place) return;
      this.#going = null;
      if (expected) view.aim(expected);
    });
  }

  /** @param {Point} point a click in the frame that is shown */
  set(point) {
    if (!this.#meant()) return;
    const here = this.here;
    const lost = this.#lost(here);
    this.mending.set(here, point);
    if (!lost) this.#tell(words.setAnew, here);
    this.#done(here, lost);
  }

  /** There is no mark to be seen in this frame. */
  leave() {
    if (!this.#meant()) return;
    const here = this.here;
    this.mending.leave(here);
    this.#done(here, true);
  }

  /** Takes back what was set or left out last. */
  undo() {
    const place = this.mending.undo();
    if (!place) return;
    this.film.changed();
    if (this.#lost(place)) return this.#go(place);
    this.#tell(words.asBefore, place);
    this.#going = null;
    void this.film.frames.want((this.mending.rows[place.row]?.t ?? 0) + 1e-6);
  }

  /** Whether it is known whose place is meant, in the frame that stands there. */
  #meant() {
    const known = NAMES.includes(this.film.setup.aim);
    if (!known) this.film.say(words.chooseMark());
    return known && !this.#going;
  }

  /** @param {Place} place */
  #lost({ row, mark }) {
    return this.mending.lost.some((one) => one.row === row && one.mark === mark);
  }

  /** @param {(name: string, time: string) => string} text @param {Place} place */
  #tell(text, { row, mark }) {
    this.film.say(text(NAMES[mark] ?? "", fixed(this.mending.rows[row]?.t ?? 0, 3)));
  }

  /** @param {Place} here @param {boolean} on whether another lost place is looked for */
  #done(here, on) {
    const { setup, changed, say, read } = this.film;
    const next = on ? this.mending.after(here) : null;
    if (next) return this.#go(next);
    if (on) setup.aim = ""; // a click that only means to look changes nothing
    setup.show();
    changed();
    if (!on) return;
    say(words.noneLost());
    read();
  }
}
