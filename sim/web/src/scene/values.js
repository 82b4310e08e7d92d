/**
 * The values that the reader has changed: asked for, accepted by Python, and those before, for
 * “undo”. A slider that is dragged counts as one change.
 */

import { asText } from "../shared/settings.js";

/** @typedef {Record<string, number | string | boolean>} Settings paths such as A.mass to SI numbers, text with a unit, or whether an effect acts */

const ONE_CHANGE = 1000; // ms; changes of one target that follow so soon are one
const MOST = 50;

export class Values {
  /** @type {Settings} accepted: those of the run that is shown */
  good = {};
  /** @type {Settings} asked for, newest */
  wanted = {};
  /** @type {Settings[]} */
  #before = [];
  #last = { target: "", at: 0 };

  /** @param {Settings} changes */
  ask(changes) {
    const target = Object.keys(changes).join();
    if (!target) return;
    const now = performance.now();
    if (target !== this.#last.target || now - this.#last.at > ONE_CHANGE) {
      this.#before.push({ ...this.wanted });
      if (this.#before.length > MOST) this.#before.shift();
    }
    this.#last = { target, at: now };
    Object.assign(this.wanted, changes);
  }

  /** @returns {Set<string>} what newer values were asked for than those of the run on screen */
  get pending() {
    const keys = Object.keys(this.wanted);
    return new Set(keys.filter((key) => this.wanted[key] !== this.good[key]));
  }

  /** A refused value goes back to the last good one. @param {Settings} changes */
  giveUp(changes) {
    for (const [key, value] of Object.entries(changes)) {
      if (this.wanted[key] !== value) continue;
      const good = this.good[key];
      if (good === undefined) delete this.wanted[key];
      else this.wanted[key] = good;
    }
    if (JSON.stringify(this.#before.at(-1)) !== JSON.stringify(this.wanted)) return;
    this.#before.pop(); // nothing was changed: nothing to undo
    this.#last.target = "";
  }

  /** Other values in the place of all, as one change. @param {Settings} changes @returns {() => void} how all is as it was, if they are refused */
  replace(changes) {
    const before = [...this.#before];
    if (asText(this.wanted) !== asText(changes)) {
      this.#before.push({ ...this.wanted });
    }
    this.wanted = { ...changes };
    this.#last.target = "";
    return () => {
      this.wanted = { ...this.good };
      this.#before = before;
      this.#last.target = "";
    };
  }

  get canUndo() {
    return this.#before.length > 0;
  }

  /** Goes back by one change; the caller then asks for a run. */
  undo() {
    this.wanted = this.#before.pop() ?? {};
    this.#last.target = "";
  }

  reset() {
    if (Object.keys(this.wanted).length) this.#before.push({ ...this.wanted });
    this.wanted = {};
    this.good = {};
    this.#last.target = "";
  }

  forget() {
    this.reset();
    this.#before = [];
  }
}
