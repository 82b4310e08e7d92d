/**
 * A run is watched before it is known: until it was played to its end once, the page holds of it what
 * was seen. Where a lesson has it free (`watch: free`), everything is there from the start.
 */

import { recall, retain } from "../../shared/tab.js";

export const WATCHED = "carts-watched"; // an event of the scene, once, when its run was seen

export class Watch {
  over = false;

  /**
   * @param {HTMLElement} element of the scene @param {import("../../../../view/types.js").Baked} baked
   * @param {import("./player.js").Player} player @param {() => void} ended once, when all was seen
   */
  constructor(element, baked, player, ended) {
    this.element = element;
    this.player = player;
    this.ended = ended;
    this.first = baked.fence.watch === "first";
    this.asked = baked.fence.predict !== null;
    this.button = /** @type {HTMLButtonElement | null} */ (element.querySelector(".carts-end"));
    this.button?.addEventListener("click", () => {
      player.pause();
      player.show(player.until);
    });
    if (this.first) player.seen = 0;
    player.ended = () => this.finish();
    if (!this.asked && remembered().includes(this.#name)) this.#open();
  }

  /** All of the run is there from now on. */
  finish() {
    if (this.over) return;
    this.#open();
    this.player.seek(this.player.time);
    this.ended();
  }

  #open() {
    this.over = true;
    this.player.seen = Infinity;
    if (this.button) this.button.style.visibility = "hidden"; // it keeps its place: nothing moves
    if (!this.asked) remember(this.#name);
    this.element.dataset.watched = "";
    this.element.dispatchEvent(new CustomEvent(WATCHED, { bubbles: true }));
  }

  get #name() {
    return `${location.pathname}#${this.element.id}`;
  }
}

const KEY = "carts-watched";

/** What this tab has watched before; a scene with a prediction keeps it with the answer. @returns {string[]} */
function remembered() {
  return recall(KEY) ?? [];
}

/** @param {string} name */
function remember(name) {
  retain(KEY, [...new Set([...remembered(), name])]);
}
