/** What a film needs before it is followed: both marks, both ends of the ruler, its length, and how slow the film runs. */

import { need } from "../shared/dom.js";
import {
  complainUnlessPositive,
  ifTyped,
  numberIn,
  problemIn,
  unlessPositive,
} from "../shared/number-box.js";
import * as words from "./words.js";

/** @typedef {import("./along.js").Point} Point */
/** @typedef {import("./words.js").Aim} Aim */
/** @typedef {Point & {radius?: number}} Chosen */

const AIMS = /** @type {Aim[]} */ (["A", "B", "one", "other"]);
export const FEWEST = 8; // frames that are followed: as of any readings, sim/measured/track.py
const METRES = /** @type {Record<string, number>} */ ({ m: 1, cm: 0.01 });

export class Setup {
  /** @type {Partial<Record<Aim, Chosen>>} */
  points = {};
  /** @type {Aim | ""} none: after following, until a button is pressed */
  aim = "A";
  /** @type {Aim[]} what can be set now */
  offered = [];
  #slower = 1;

  /** @param {HTMLElement} root @param {() => void} changed the aim or a number is another now */
  constructor(root, changed) {
    const find = (/** @type {string} */ name) =>
      /** @type {HTMLInputElement} */ (need(root, `.carts-film-${name}`));
    this.boxes = { length: find("length"), slower: find("slower") };
    this.unit = /** @type {HTMLSelectElement} */ (need(root, ".carts-film-unit"));
    /** @type {HTMLButtonElement[]} */
    this.buttons = [...root.querySelectorAll("[data-aim]")].map(
      (button) => /** @type {HTMLButtonElement} */ (button),
    );
    for (const button of this.buttons) {
      button.addEventListener("click", () => {
        this.aim = /** @type {Aim} */ (button.dataset.aim);
        changed();
      });
    }
    this.inputs = [...Object.values(this.boxes), this.unit];
    for (const input of this.inputs) input.addEventListener("input", changed);
    const { length, slower } = this.boxes;
    length.addEventListener("change", () => {
      complainUnlessPositive(length, ifTyped(length));
      changed();
    });
    slower.addEventListener("change", () => complainUnlessPositive(slower, problemIn(slower)));
  }

  /** @param {Chosen} point for what is aimed at; the first that is still open is aimed at next */
  set(point) {
    if (this.aim) this.points[this.aim] = point;
    this.aim = AIMS.find((aim) => !this.points[aim]) ?? this.aim;
  }

  /** Whether a mark that was found is that of the other cart. @param {Chosen} mark @returns {boolean} */
  isOther(mark) {
    const other = this.points[this.aim === "A" ? "B" : "A"];
    return Boolean(other && near(other, mark, Math.max(1, other.radius ?? 0)));
  }

  /** @returns {string} what is to be done before the film can be followed, or to follow it */
  get next() {
    const { aim, points, boxes } = this;
    if (aim && (!this.placed || !points[aim])) return words.asked(aim);
    const { length } = boxes;
    const wrong = length !== document.activeElement && unlessPositive(length, ifTyped(length));
    if (wrong) return words.lengthIsNone(wrong);
    const { one, other } = points;
    return one && other && near(one, other, 1) ? words.endsAlike() : words.askLength();
  }

  /** Marks hold for the frame in which they were clicked. */
  forgetMarks() {
    delete this.points.A;
    delete this.points.B;
    this.aim = "A";
  }

  /** @returns {boolean} whether a cart's mark is set */
  get marked() {
    return Boolean(this.points.A || this.points.B);
  }

  /** @returns {boolean} whether every place is set */
  get placed() {
    return AIMS.every((aim) => this.points[aim]);
  }

  /** @returns {number} m; not a number where none is typed */
  get length() {
    return (numberIn(this.boxes.length) ?? Number.NaN) * Number(METRES[this.unit.value]);
  }

  /** @returns {number} how many times slower than life the film runs; of what makes no sense, the number before */
  get slower() {
    const typed = numberIn(this.boxes.slower) ?? 0;
    if (typed > 0) this.#slower = typed;
    return this.#slower;
  }

  /** @returns {import("./along.js").Ruler | null} null: not known yet */
  get ruler() {
    const { one, other } = this.points;
    if (!one || !other || !(this.length > 0)) return null;
    if (numberIn(this.boxes.slower) !== this.slower) return null; // how slow is not known
    if (near(one, other, 1)) return null;
    return { ends: [one, other], length: this.length };
  }

  /** @returns {Chosen[]} */
  get marks() {
    const { A, B } = this.points;
    return A && B ? [A, B] : [];
  }

  /** Shows what can be set now. */
  show() {
    const { offered } = this;
    for (const button of this.buttons) {
      const aim = /** @type {Aim} */ (button.dataset.aim);
      button.disabled = !offered.includes(aim);
      button.setAttribute("aria-pressed", String(!button.disabled && aim === this.aim));
      button.classList.toggle("carts-film-set", Boolean(this.points[aim]));
    }
    for (const input of this.inputs) input.disabled = !offered.length;
  }
}

/** @param {Point} a @param {Point} b @param {number} pixels */
function near(a, b, pixels) {
  return Math.hypot(a.x - b.x, a.y - b.y) < pixels;
}
