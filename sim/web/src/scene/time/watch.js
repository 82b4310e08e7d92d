/**
 * A run is watched before it is known: until it was played to its end once, the page holds of it what
 * was seen. Of a scene with ready-made settings each one is watched: a wall tells something else than
 * foam. Where a lesson has it free (`watch: free`), everything is there from the start.
 */

import { tr } from "../../../../view/language.js";
import { need, say } from "../../shared/dom.js";
import { recall, retain } from "../../shared/tab.js";

export const PROJECTED = "carts-projector"; // class of a scene that a whole class watches: one run is enough
export const WATCHED = "carts-watched"; // an event of the scene, once, when all of it was seen

export class Watch {
  over = false; // a run was seen to its end: values may be changed
  whole = false; // and so was that of each ready-made setting

  /**
   * @param {HTMLElement} element of the scene @param {import("../../../../view/types.js").Baked} baked
   * @param {import("./player.js").Player} player @param {import("../presets.js").Presets} presets
   * @param {{first: () => void, all: () => void}} acts what to do once, when a run was seen and when all was
   */
  constructor(element, baked, player, presets, acts) {
    this.element = element;
    this.player = player;
    this.presets = presets;
    this.acts = acts;
    this.first = baked.fence.watch === "first";
    this.asked = baked.fence.predict !== null;
    this.button = /** @type {HTMLButtonElement | null} */ (element.querySelector(".carts-end"));
    this.button?.addEventListener("click", () => {
      if (this.whole) return compared(element).focus();
      player.pause();
      player.show(player.until);
    });
    if (this.first) player.seen = 0;
    player.ended = () => this.finish(element.classList.contains(PROJECTED));
    const before = this.first ? remembered() : [];
    presets.seen(presets.names.filter((name) => !this.first || before.includes(this.#of(name))));
    if (!this.asked && before.includes(this.#name)) this.#end();
  }

  /** The run on the page was seen. @param {boolean} all as if those of all ready-made settings were too */
  finish(all = false) {
    const begun = this.over;
    const hidden = this.player.seen !== Infinity; // that of a further ready-made setting, too
    const here = all ? this.presets.names : this.presets.pressed;
    this.over = true;
    this.player.seen = Infinity;
    if (!this.whole) {
      this.presets.seen(here);
      if (!all) remember(here.map((name) => this.#of(name)));
      this.#offer(false);
    }
    const done = !this.whole && this.presets.left.length === 0;
    if (done) this.#end();
    if (!begun || done || hidden) this.player.seek(this.player.time);
    if (!begun) this.acts.first();
    if (done) {
      this.acts.all();
      this.#lead();
    }
  }

  /** A ready-made setting was pressed: if its run was never watched, it plays by itself now. @param {string} name @param {() => Promise<boolean>} draw resolves to whether its run is on the page */
  preset(name, draw) {
    const { player } = this;
    const waits = this.first && this.presets.left.includes(name);
    const before = player.seen;
    player.pause();
    if (waits) player.seen = 0;
    player.seek(0);
    void draw().then((drawn) => {
      if (!drawn) {
        player.seen = before;
        return player.seek(0);
      }
      if (!waits) {
        if (this.first) player.seen = Infinity; // watched before another that was left half-way
        return player.seek(player.time);
      }
      this.#offer(true);
      player.play();
    });
  }

  /** Back at the start, with the values of the lesson: a ready-made setting that was left half-way hides nothing of them. */
  back() {
    const waits = this.presets.pressed.some((name) => this.presets.left.includes(name));
    if (this.over && !waits) {
      this.player.seen = Infinity;
      if (!this.whole) this.#offer(false);
    }
    this.player.seek(0);
  }

  #end() {
    this.over = true;
    this.whole = true;
    this.player.seen = Infinity;
    this.presets.seen(this.presets.names);
    this.#offer(false);
    if (!this.asked) remember([this.#name]);
    this.element.dataset.watched = "";
    this.element.dispatchEvent(new CustomEvent(WATCHED, { bubbles: true }));
  }

  /** What was predicted stands below what one plays with: the button leads there. */
  #lead() {
    if (!this.button || !this.asked || compared(this.element).hidden) return;
    say(this.button, tr("My prediction ↓"));
    this.#offer(true);
  }

  /** The button keeps its place where it is not needed: nothing moves. @param {boolean} on */
  #offer(on) {
    if (this.button) this.button.style.visibility = on ? "" : "hidden";
  }

  get #name() {
    return nameOf(this.element);
  }

  /** @param {string} preset */
  #of(preset) {
    return `${this.#name}/${preset}`;
  }
}

/** Where prediction and run stand beside each other. @param {HTMLElement} element */
const compared = (element) => need(element, ".carts-compared");

const KEY = "carts-watched";

/** What this tab has watched before; a scene with a prediction keeps it with the answer. @returns {string[]} */
function remembered() {
  return recall(KEY) ?? [];
}

/** The next reader of a scene has watched none of its runs: what waited for them waits again. @param {HTMLElement} element */
export function forgetWatched(element) {
  const name = nameOf(element);
  delete element.dataset.watched;
  const others = remembered().filter((one) => one !== name && !one.startsWith(`${name}/`));
  retain(KEY, others);
  element.dispatchEvent(new Event("carts-unwatched", { bubbles: true }));
}

/** @param {HTMLElement} element */
const nameOf = (element) => `${location.pathname}#${element.id}`;

/** @param {string[]} names */
function remember(names) {
  if (names.length) retain(KEY, [...new Set([...remembered(), ...names])]);
}
