/** How sure a reader is of a prediction, where the lesson asks for it (`sure: true`). */

import { tr } from "../../../view/language.js";

export class Sure {
  #asked = false;

  /** @param {HTMLElement} root of the prediction @param {(word: string) => void} chosen */
  constructor(root, chosen) {
    const radios = root.querySelectorAll(".carts-certainty input");
    this.radios = /** @type {HTMLInputElement[]} */ ([...radios]);
    for (const radio of this.radios) radio.addEventListener("change", () => chosen(radio.value));
  }

  /** What is passed over cannot be said after the lock: that is asked once. @returns {string} the question, or nothing */
  passedOver() {
    const said = this.radios.some((radio) => radio.checked);
    if (said || this.#asked || !this.radios.length) return "";
    this.#asked = true;
    return tr("How sure are you? Choose one, or lock without it.");
  }

  /** @param {string | undefined} word @param {boolean} open whether it can still be said */
  show(word, open) {
    for (const radio of this.radios) {
      radio.checked = radio.value === word;
      radio.disabled = !open;
    }
  }
}
