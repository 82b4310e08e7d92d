/** The description of the picture: it follows the clock when that stands still. */

import { instant } from "../../../view/instant.js";
import { say } from "../shared/dom.js";

const REST = 250; // ms: while the time is pulled, nobody listens

export class Described {
  #timer = 0;
  #told = false;
  /** @type {string | null} the carts that the page describes at the start */
  #start = null;

  /** @param {HTMLElement} root @param {import("../../../view/types.js").Baked} baked */
  constructor(root, { fence, view }) {
    this.place = root.querySelector(`#${CSS.escape(fence.id)}-described`);
    this.fence = fence;
    this.view = view;
  }

  /** @param {import("../../../view/types.js").Run} run @param {number} t in s @returns {string} the instant in words */
  words(run, t) {
    return instant(run, t, this.view, this.fence.camera, this.fence.forces === "shown");
  }

  /** @param {import("../../../view/types.js").Run} run @param {number} t in s @param {boolean} moving */
  at(run, t, moving) {
    clearTimeout(this.#timer);
    if (moving || !this.place || run.trajectory.t.length < 2) return;
    if (t === 0 && !this.#told) {
      const start = JSON.stringify(run.header.bodies);
      this.#start ??= start;
      if (start === this.#start) return; // the page says more of the start
    }
    this.#told = true;
    this.#timer = setTimeout(() => {
      if (this.place) say(this.place, this.words(run, t));
    }, REST);
  }
}
