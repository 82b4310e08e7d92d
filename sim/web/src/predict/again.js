/** “Start again”: for the next reader at this computer. It asks once, in the page. */

import { need } from "../shared/dom.js";

export class Again {
  /** @param {HTMLElement} root of the prediction @param {() => void} forget */
  constructor(root, forget) {
    this.row = need(root, ".carts-again-row");
    this.button = need(root, ".carts-again");
    this.question = need(root, ".carts-forget");
    const keep = need(root, ".carts-forget-no");
    this.button.addEventListener("click", () => {
      this.#ask(true);
      keep.focus();
    });
    keep.addEventListener("click", () => {
      this.#ask(false);
      this.button.focus();
    });
    need(root, ".carts-forget-yes").addEventListener("click", forget);
  }

  /** Shows the button: a prediction is locked. */
  offer() {
    this.row.hidden = false;
  }

  /** @param {boolean} on */
  #ask(on) {
    this.question.hidden = !on;
    this.button.hidden = on;
  }
}
