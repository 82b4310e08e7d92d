/**
 * Follows one mark from frame to frame: says where to look next, and takes what is seen there.
 *
 * The mark is expected to go on as it went; but in a contact it may stop or turn between two frames, so the
 * search reaches from there back to where it was, and beyond. A mark that is not found is lost in this frame,
 * and looked for in a larger piece of the next.
 */

import { clamp } from "./clamp.js";
import { markAt, LARGEST as REACH } from "./mark.js";
import { find, searched, templateOf } from "./match.js";
import { boxAround } from "./patch.js";

/** @typedef {import("./patch.js").Box} Box */
/** @typedef {import("./patch.js").Patch} Patch */
/** @typedef {{width: number, height: number}} Size */
/** @typedef {{x: number, y: number}} Point */

const ALIKE = 0.5; // less alike is lost
const FIRST = 1 / 12; // of the picture's width: a mark may go so far between the first two frames
const LEAST = 1 / 40; // of the width, in every later search
const MOST = 1 / 4; // of the width, when the mark is lost
const FLAT = 0.6; // tracks lie level: the search is so much lower than it is wide
const LATER = 0.5; // s; how fast a mark went so long ago says nothing

/** The piece of a frame in which a click is looked at. @param {Point} click @param {Size} picture */
export const around = ({ x, y }, picture) => boxAround(x, y, 2 * REACH + 4, 2 * REACH + 4, picture);

export class Follower {
  /** @type {Point} */
  #at;
  /** @type {Point} pixels per second */
  #speed = { x: 0, y: 0 };
  #time;
  #seen = 1; // frames in which it was found
  #missed = 0; // since

  /** @param {import("./match.js").Template} template @param {Point} at @param {number} time s @param {Size} picture */
  constructor(template, at, time, picture) {
    this.template = template;
    this.picture = picture;
    this.#at = at;
    this.#time = time;
  }

  /** @param {Patch} patch around the click @param {Point} click @param {number} time s @param {Size} picture @returns {Follower | null} null: nothing stands out there */
  static of(patch, click, time, picture) {
    const mark = markAt(patch, click.x, click.y);
    return mark && new Follower(templateOf(patch, mark), mark, time, picture);
  }

  get place() {
    return this.#at;
  }

  /** @param {number} time s @returns {Point} where the mark is if it goes on as it went */
  #expected(time) {
    const later = time - this.#time;
    const on = later < LATER ? later : 0;
    const [x, y] = [this.#at.x + on * this.#speed.x, this.#at.y + on * this.#speed.y];
    const { width, height } = this.picture;
    return { x: clamp(x, 0, width - 1), y: clamp(y, 0, height - 1) };
  }

  /** Where to look in the frame at this time. @param {number} time s @returns {Box} */
  box(time) {
    const { width } = this.picture;
    const to = this.#expected(time);
    const known = Math.max((this.#seen > 1 ? LEAST : FIRST) * width, 2 * this.template.half);
    const reach = Math.min(known * (1 + this.#missed), Math.max(known, MOST * width));
    const across = reach + Math.abs(to.x - this.#at.x);
    const up = FLAT * reach + Math.abs(to.y - this.#at.y);
    return searched(this.template, to.x, to.y, across, up, this.picture);
  }

  /** @param {Patch} patch of the box at this time @param {number} time s @returns {Point | null} null: lost in this frame */
  take(patch, time) {
    const { x, y } = this.#expected(time);
    const found = find(patch, this.template, x, y);
    if (!found || found.alike < ALIKE) {
      this.#missed += 1;
      return null;
    }
    this.put(found, time);
    return { x: found.x, y: found.y };
  }

  /** Goes on from here. @param {Point} at @param {number} time s */
  put({ x, y }, time) {
    const passed = time - this.#time;
    if (passed > 0) {
      this.#speed = { x: (x - this.#at.x) / passed, y: (y - this.#at.y) / passed };
    }
    this.#at = { x, y };
    this.#time = time;
    this.#seen += 1;
    this.#missed = 0;
  }
}
