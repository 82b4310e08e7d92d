/**
 * Between the lock and the run: two readers compare what they said. The prediction may then be
 * changed once; both are kept.
 */

import { need } from "../shared/dom.js";

export class Talk {
  /** @param {HTMLElement} root of the prediction @param {{change: () => void, run: () => void}} acts */
  constructor(root, { change, run }) {
    this.box = need(root, ".carts-talk");
    need(this.box, ".carts-talk-change").addEventListener("click", () => {
      change();
      // the button is gone now: who goes by keyboard is at what can be changed
      need(root, ".carts-guess input, .carts-height, input:checked, textarea").focus();
    });
    need(this.box, ".carts-talk-run").addEventListener("click", run);
  }

  /** @param {boolean} on whether it is time to talk @param {boolean} asked by the reader just now */
  show(on, asked) {
    this.box.hidden = !on;
    if (on && asked) this.box.focus(); // not a button: Enter that is still held would press it
  }
}

/** The reader's own explanation, after the run. */
export class Why {
  /** @param {HTMLElement} root of the prediction @param {(text: string) => void} changed */
  constructor(root, changed) {
    this.line = need(root, ".carts-why");
    this.box = /** @type {HTMLTextAreaElement} */ (need(this.line, "textarea"));
    this.box.addEventListener("input", () => changed(this.box.value));
  }

  /** @param {string} text */
  show(text) {
    this.line.hidden = false;
    if (this.box.value !== text) this.box.value = text;
  }
}
