/**
 * Contact-force arrows: fill is the body it acts on, tail on that body's own bumper face, pointing
 * into it, named “on A by B”. One linear scale for the scene; zero is a dot. Nothing stays behind
 * when the contact is over.
 */

import { need, put, say } from "./dom.js";
import { fixed, px } from "./numbers.js";
import { arrowLength, blockArrow, cutArrow, isCut, PUSH } from "./shapes.js";
import { valueAt } from "./trajectory.js";
import { brief, isWall } from "./words.js";

/** @typedef {import("./types.js").Run} Run */
/** @typedef {(name: string, side: "left" | "right") => number} Face drawing coordinate of a bumper face */
/** @typedef {{pair: string, bodies: [string, string], row: number, groups: [Element, Element]}} Push */

const PER_CHARACTER = 6.6; // units, of the bold names on the beam
const ROW = 19; // units between two rows of names
const GAP = 8; // units between a name and the place of contact

export class Pushes {
  /** @type {Push[]} */
  #pushes = [];
  /** @type {Run | null} */
  #run = null;
  /** @type {import("./windows.js").Touch[]} */
  #windows = [];

  /** @param {SVGElement} root @param {import("./types.js").Layout} layout @param {import("./types.js").View} view */
  constructor(root, layout, view) {
    this.root = root;
    this.layout = layout;
    this.view = view;
  }

  /** @param {Run} run @param {import("./windows.js").Touch[]} windows */
  show(run, windows) {
    this.#run = run;
    this.#windows = windows;
    this.#pushes = [];
    run.header.contacts.forEach((contact, k) => {
      const groups = contact.bodies.map((name) =>
        this.root.querySelector(`.carts-push[data-pair="${contact.pair}"][data-on="${name}"]`),
      );
      if (groups[0] && groups[1]) {
        const row = this.layout.rows[k] ?? 0;
        this.#pushes.push({
          pair: contact.pair,
          bodies: contact.bodies,
          row,
          groups: [groups[0], groups[1]],
        });
      }
    });
  }

  /** @param {number} t in s @param {Face} face */
  at(t, face) {
    const run = this.#run;
    if (!run) return;
    const { layout, view } = this;
    for (const push of this.#pushes) {
      const { t: times, F, dF } = run.trajectory;
      const force = valueAt(times, F[push.pair] ?? [0], dF[push.pair] ?? [0], t);
      const size = Math.max(0, force < 1e-9 * view.force ? 0 : force);
      const length = Math.abs(arrowLength(size, view.force, layout.force));
      const y = layout.track - PUSH;
      const [left, right] = push.bodies;
      const ends = [face(left, "right"), face(right, "left")];
      const touching = this.#windows.some(
        (w) => w.pair === push.pair && t >= w.start && t <= w.end,
      );
      const draw = isCut(size, view.force) ? cutArrow : blockArrow;
      push.groups.forEach((group, side) => {
        const way = side === 0 ? -1 : 1;
        put(need(group, '[data-part="arrow"]'), "d", draw(Number(ends[side]), y, way * length));
      });
      this.#names(push, size, (Number(ends[0]) + Number(ends[1])) / 2, touching);
    }
  }

  /** Both names on the beam, left and right of the contact, clear of each other and of the edges. */
  /** @param {Push} push @param {number} size @param {number} x @param {boolean} visible */
  #names(push, size, x, visible) {
    const texts = push.groups.map((group) => need(group, '[data-part="text"]'));
    for (const text of texts) put(text, "visibility", visible ? "visible" : "hidden");
    if (!visible) return;
    const cut = isCut(size, this.view.force) ? ", arrow cut" : "";
    const value = `${fixed(size, this.view.decimals.F ?? 2)} N${cut}`;
    const labels = push.bodies.map((on, side) => {
      const by = push.bodies[1 - side] ?? "";
      return `on ${brief(on)} by ${brief(by)}: ${value}`;
    });
    const wall = push.bodies.findIndex(isWall);
    if (wall >= 0) return this.#beside(texts, labels, push.row, x, wall === 0 ? 1 : -1);
    const widths = labels.map((label) => label.length * PER_CHARACTER);
    const [first, second] = [Number(widths[0]), Number(widths[1])];
    const [low, high] = this.#between(first + second + 2 * GAP);
    const right = Math.min(Math.max(x + GAP, low + first + 2 * GAP), high - second);
    const left = Math.min(x - GAP, right - 2 * GAP);
    texts.forEach((text, side) => {
      put(text, "x", px(side === 0 ? left : right));
      put(text, "y", px(push.row));
      put(text, "text-anchor", side === 0 ? "end" : "start");
      say(text, labels[side] ?? "");
    });
  }

  /**
   * Where names may stand: between the walls where there is room, else in the picture.
   * @param {number} needed in units @returns {[number, number]}
   */
  #between(needed) {
    const { origin, scale, width } = this.layout;
    const track = this.#run?.header.track;
    const low = track?.left === "wall" ? Math.max(6, origin + 4) : 6;
    const end = origin + (track?.length ?? 0) * scale - 4;
    const high = track?.right === "wall" ? Math.min(width - 6, end) : width - 6;
    return high - low >= needed ? [low, high] : [6, width - 6];
  }

  /**
   * The names of a contact with a wall stand one above the other on the track, clear of the wall.
   * @param {Element[]} texts @param {string[]} labels @param {number} row @param {number} x @param {1 | -1} way
   */
  #beside(texts, labels, row, x, way) {
    const longest = Math.max(...labels.map((label) => label.length)) * PER_CHARACTER;
    const at = Math.min(Math.max(x + way * GAP, way < 0 ? longest : 6), this.layout.width - 6);
    texts.forEach((text, side) => {
      put(text, "x", px(at));
      put(text, "y", px(row + side * ROW));
      put(text, "text-anchor", way > 0 ? "start" : "end");
      say(text, labels[side] ?? "");
    });
  }
}
