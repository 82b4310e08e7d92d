/** One polite live region per scene. It tells events, not every frame. */

import { need } from "../shared/dom.js";

const MOST = 3; // sentences at once; more would never be heard to the end

export class Announcer {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.world = need(root, ".carts-world");
    this.region = need(root, ".carts-announcer");
  }

  /** After a lock its button is gone: the next thing to do is there, and the run begins in sight. @param {HTMLElement} next @param {string} sentence */
  leadTo(next, sentence) {
    const focused = document.activeElement;
    if (!focused || focused === document.body || focused.matches(".carts-lock")) {
      next.focus({ preventScroll: true });
    }
    const { top, height } = this.world.getBoundingClientRect();
    // Where little fits, its upper part is seen, with the velocities; “nearest” may show the lower.
    const upper = top < 0 || height > innerHeight / 2;
    this.world.scrollIntoView({ block: upper ? "start" : "nearest" });
    this.tell([sentence]);
  }

  /** @param {string[]} sentences */
  tell(sentences) {
    if (sentences.length) this.region.textContent = sentences.slice(-MOST).join(" ");
  }
}
