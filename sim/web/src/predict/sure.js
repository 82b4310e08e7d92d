/** How sure a reader is of a prediction, where the lesson asks for it (`sure: true`). */

export class Sure {
  /** @param {HTMLElement} root of the prediction @param {(word: string) => void} chosen */
  constructor(root, chosen) {
    const radios = root.querySelectorAll(".carts-certainty input");
    this.radios = /** @type {HTMLInputElement[]} */ ([...radios]);
    for (const radio of this.radios) radio.addEventListener("change", () => chosen(radio.value));
  }

  /** @param {string | undefined} word @param {boolean} open whether it can still be said */
  show(word, open) {
    for (const radio of this.radios) {
      radio.checked = radio.value === word;
      radio.disabled = !open;
    }
  }
}
