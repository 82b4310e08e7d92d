/**
 * Contact-force arrows: fill is the body it acts on, tail on that body's own bumper face, pointing
 * into it, named “on A by B”. One linear scale for the scene; zero is a dot. Nothing stays behind
 * when the contact is over.
 */

import { isWall, onBy } from "../../../view/bodies.js";
import { linkOf } from "../../../view/effects.js";
import { tr } from "../../../view/language.js";
import { fixed, NOISE, px } from "../../../view/numbers.js";
import { arrowLength, blockArrow, cutArrow, isCut, PUSH } from "../../../view/shapes.js";
import { valueAt } from "../../../view/trajectory.js";
import { need, put, say } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/types.js").Face} Face */
/** @typedef {{pair: string, bodies: [string, string], row: number, groups: [Element, Element]}} Push */
/** @typedef {{push: Push, sizes: number[], x: number, link: string}} Told a force that acts: sizes in N on the left and the right body, x where it is, what acts without touching */

const PER_CHARACTER = 9.1; // units, of the bold names on the beam in a wide font
const ROW = 21; // units between two rows of names
const GAP = 12; // units between a name and the place of contact or a wall: two names keep twice as much
const EDGE = 6; // units that names keep from the edges of the picture

export class Pushes {
  /** @type {Push[]} */
  #pushes = [];
  /** @type {Run | null} */
  #run = null;
  /** @type {import("../../../view/windows.js").Touch[]} */
  #windows = [];

  /** @param {SVGElement} root @param {import("../../../view/types.js").Layout} layout @param {import("../../../view/types.js").View} view */
  constructor(root, layout, view) {
    this.root = root;
    this.layout = layout;
    this.view = view;
  }

  /** @param {Run} run @param {import("../../../view/windows.js").Touch[]} windows */
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
    /** @type {Told[]} */
    const told = [];
    for (const push of this.#pushes) {
      const forces = forcesOn(run, push, t).map(
        (force) => (Math.abs(force) < NOISE * view.force ? 0 : force), // springs pull: below 0
      );
      const sizes = forces.map(Math.abs);
      const size = Math.max(...sizes);
      const y = layout.track - PUSH;
      const [left, right] = push.bodies;
      const ends = [face(left, "right"), face(right, "left")];
      push.groups.forEach((group, side) => {
        const way = side === 0 ? -1 : 1;
        const draw = isCut(Number(sizes[side]), view.force) ? cutArrow : blockArrow;
        const length = arrowLength(Number(forces[side]), view.force, layout.force);
        put(need(group, '[data-part="arrow"]'), "d", draw(Number(ends[side]), y, way * length));
      });
      const touching = this.#windows.some(
        ({ pair, loose, near, start, end, lasts }) =>
          pair === push.pair &&
          !(loose || near) &&
          t >= start &&
          (t <= end || Boolean(lasts && size > 0)), // carts that never part go on pushing
      );
      const link = touching ? "" : linkOf(run.header, push.pair);
      if (touching || (link && size > 0)) {
        told.push({ push, sizes, x: (Number(ends[0]) + Number(ends[1])) / 2, link });
      }
    }
    this.#names(told);
  }

  /** One touch is told in full; of several at once only the sizes, where there is room. @param {Told[]} told */
  #names(told) {
    const [only] = told;
    for (const { pair, groups } of this.#pushes) {
      const on = told.some(({ push }) => push.pair === pair);
      for (const group of groups) {
        put(need(group, '[data-part="text"]'), "visibility", on ? "visible" : "hidden");
      }
    }
    if (told.length === 1 && only && this.#inFull(only)) return;
    /** @type {[number, number, number][]} y, from, to */
    const taken = [];
    const [low, high] = this.#between();
    for (const { push, sizes, x } of told) {
      const size = Math.max(...sizes);
      const [text, other] = push.groups.map((group) => need(group, '[data-part="text"]'));
      if (!text || !other) continue;
      const label = tr("{size} on each", { size: this.#value(size) });
      const half = (label.length * PER_CHARACTER) / 2;
      const at = Math.min(Math.max(x, low + half), high - half);
      const free = [...new Set(this.layout.rows)].find((y) =>
        taken.every(([row, from, to]) => row !== y || at + half < from || at - half > to),
      );
      put(other, "visibility", "hidden");
      if (free === undefined) put(text, "visibility", "hidden");
      else {
        taken.push([free, at - half, at + half]);
        write(text, label, at, free, "middle");
      }
    }
  }

  /** Both names, clear of each other, of walls and of the edges. @param {Told} told @returns {boolean} whether there is room */
  #inFull(told) {
    return this.#named(told, told.link && ` (${told.link})`) || this.#named(told, "");
  }

  /** @param {Told} told @param {string} through what acts without touching @returns {boolean} whether there is room */
  #named({ push, sizes, x }, through) {
    const [first, second] = push.groups.map((group) => need(group, '[data-part="text"]'));
    const { track } = /** @type {Run} */ (this.#run).header;
    const labels = push.bodies.map((on, side) => {
      const by = push.bodies[1 - side] ?? "";
      return `${onBy(on, by, track)}${through}: ${this.#value(Number(sizes[side]))}`;
    });
    const [left, right] = labels.map((label) => label.length * PER_CHARACTER);
    if (!first || !second || !left || !right) return false;
    const [low, high] = this.#between();
    if (high - low >= left + right + 2 * GAP && !push.bodies.some(isWall)) {
      const begin = Math.min(Math.max(x + GAP, low + left + 2 * GAP), high - right);
      const end = Math.max(low + left, Math.min(x - GAP, begin - 2 * GAP));
      write(first, labels[0] ?? "", end, push.row, "end");
      write(second, labels[1] ?? "", begin, push.row, "start");
      return true;
    }
    const longest = Math.max(left, right);
    const taken = new Set(Object.values(this.layout.slots)).size; // rows of other forces
    if (this.layout.beam < (2 + taken) * ROW || high - low < longest) return false;
    const top = Math.min(...this.layout.rows);
    const way = push.bodies[0] === "left" ? 0 : push.bodies[1] === "right" ? 1 : 0.5;
    const start = Math.min(Math.max(x - way * longest, low), high - longest);
    write(first, labels[0] ?? "", start, top, "start");
    write(second, labels[1] ?? "", start, top + ROW, "start");
    return true;
  }

  /** Where names may stand: between the walls. @returns {[number, number]} */
  #between() {
    const { origin, scale, width } = this.layout;
    const track = this.#run?.header.track;
    const end = origin + (track?.length ?? 0) * scale;
    return [
      track?.left === "wall" ? Math.max(EDGE, origin + GAP) : EDGE,
      track?.right === "wall" ? Math.min(width - EDGE, end - GAP) : width - EDGE,
    ];
  }

  /** @param {number} size in N */
  #value(size) {
    const cut = isCut(size, this.view.force) ? tr(", arrow cut") : "";
    return `${fixed(size, this.view.decimals.F ?? 2)} N${cut}`;
  }
}

/**
 * N on the left and on the right body, apart: one number, but in a world that does not exist.
 * @param {Run} run @param {Push} push @param {number} t in s @returns {[number, number]}
 */
function forcesOn({ trajectory }, { pair, bodies }, t) {
  const { t: times, F, dF, on } = trajectory;
  const [left, right] = bodies.map((name) => on?.[`${pair} ${name}`]);
  if (left && right) return [valueAt(times, left, null, t), valueAt(times, right, null, t)];
  const [column, slopes] = [F[pair], dF[pair]]; // none where the two never touch
  const force = column && slopes ? valueAt(times, column, slopes, t) : 0;
  return [force, force];
}

/** @param {Element} text @param {string} label @param {number} x @param {number} y @param {string} anchor */
function write(text, label, x, y, anchor) {
  put(text, "x", px(x));
  put(text, "y", px(y));
  put(text, "text-anchor", anchor);
  say(text, label);
}
