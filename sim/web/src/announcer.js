/** One polite live region per scene. It tells events, not every frame. */

import { need } from "./dom.js";

const MOST = 3; // sentences at once; more would never be heard to the end

export class Announcer {
  /** @param {HTMLElement} root */
  constructor(root) {
    this.region = need(root, ".carts-announcer");
  }

  /** @param {string[]} sentences */
  tell(sentences) {
    if (sentences.length) this.region.textContent = sentences.slice(-MOST).join(" ");
  }
}
