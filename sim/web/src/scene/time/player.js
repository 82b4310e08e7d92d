/** Play, pause, step and scrub are one number: the time shown. */

import { advance, slowAt } from "./slow.js";

const SAME = 1e-12; // s; nearer is the same instant, but for rounding
const STEP = 0.04; // s on the screen that one step stands for
const STILL = 1; // s on the screen between two stills
const LONGEST_FRAME = 0.1; // s; a page that was asleep does not leap

export class Player {
  time = 0;
  own = 0; // s that the reader has watched since the start
  playing = false;
  speed = 1;
  slow = true;
  until = 1;
  /** As far as the run was watched, in s: a reader goes back and forth up to there. Infinity: all of it. */
  seen = Infinity;
  ended = () => {}; // what to do at the end of the run
  /** What to do after steps. @type {(before: number) => void} */
  stepped = () => {};
  /** @type {import("./slow.js").SlowPart[]} */
  parts = [];
  /** @type {number[]} s, where playing stops by itself */
  halts = [];
  halting = false;
  /** @type {number[]} */
  stops = [];
  /** Whether playing shows a still each second, and each event, in place of motion. */
  stills = matchMedia("(prefers-reduced-motion: reduce)").matches;
  #waited = 0; // s since the last still
  #frame = 0;
  #last = 0;

  /** @param {(before: number, playing: boolean) => void} changed after every change of time or state */
  constructor(changed) {
    this.changed = changed;
  }

  get #parts() {
    return this.slow ? this.parts : [];
  }

  /** @returns {number} cart seconds per second now */
  get rate() {
    return Math.min(this.speed, slowAt(this.#parts, this.time)?.rate ?? this.speed);
  }

  /** @returns {boolean} whether slow motion is on at this instant */
  get isSlow() {
    return this.rate < this.speed;
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  play() {
    if (this.playing) return;
    if (this.time >= this.until) this.#move(0);
    if (this.time === 0) this.own = 0;
    this.playing = true;
    this.#last = 0;
    this.#waited = 0;
    this.changed(this.time, false);
    this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  pause() {
    if (!this.playing) return;
    this.playing = false;
    cancelAnimationFrame(this.#frame);
    this.changed(this.time, false);
  }

  /** @param {number} t in s */
  seek(t) {
    this.#move(Math.min(t, this.seen));
    if (t <= 0) this.own = 0;
    this.#tell(this.time, false);
  }

  /** Goes there, watched or not. @param {number} t in s */
  show(t) {
    this.seen = Math.max(this.seen, t);
    this.seek(t);
  }

  /** One step; it does not pass over an event. @param {1 | -1} way @param {number} count */
  step(way, count = 1) {
    this.pause();
    const start = this.time;
    for (let k = 0; k < count; k += 1) {
      const before = this.time;
      const target = before + way * STEP * this.rate;
      const event =
        way > 0
          ? this.stops.find((t) => t > before + SAME)
          : this.stops.findLast((t) => t < before - SAME);
      const passed = event !== undefined && (way > 0 ? event < target : event > target);
      this.#move(passed ? event : target);
      this.#tell(before, way > 0);
    }
    this.stepped(start);
  }

  /** @param {number} now */
  #tick(now) {
    if (!this.playing) return;
    const seconds = this.#last ? Math.min(LONGEST_FRAME, (now - this.#last) / 1000) : 0;
    this.#last = now;
    const before = this.time;
    this.own += seconds;
    this.#waited += seconds;
    if (this.stills && this.#waited < STILL) {
      this.#frame = requestAnimationFrame((next) => this.#tick(next));
      return;
    }
    const shown = this.stills ? this.#waited : seconds;
    this.#waited = 0;
    let next = advance(before, shown, this.speed, this.#parts, this.until);
    if (this.stills) next = this.stops.find((t) => t > before + SAME && t < next) ?? next;
    const halt = this.halting ? this.halts.find((t) => t > before + SAME && t <= next) : undefined;
    this.#move(halt ?? next);
    if (halt !== undefined || this.time >= this.until) this.playing = false;
    this.#tell(before, true);
    if (this.playing) this.#frame = requestAnimationFrame((next) => this.#tick(next));
  }

  /** @param {number} t */
  #move(t) {
    this.time = Math.min(this.until, Math.max(0, t));
    this.seen = Math.max(this.seen, this.time);
  }

  /** @param {number} before @param {boolean} playing */
  #tell(before, playing) {
    this.changed(before, playing);
    if (this.time >= this.until) this.ended();
  }
}
