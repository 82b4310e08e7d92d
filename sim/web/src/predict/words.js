/** Predictions by choosing an option or by writing a sentence. */

import { tr } from "../../../view/language.js";
import { html, need } from "../shared/dom.js";
import { OnceMore } from "./once-more.js";

export class ChoiceForm {
  /** @param {HTMLElement} root @param {() => void} changed */
  constructor(root, changed) {
    this.radios = /** @type {HTMLInputElement[]} */ ([
      ...root.querySelectorAll('.carts-options input[type="radio"]'), // not those of how sure one is
    ]);
    for (const radio of this.radios) radio.addEventListener("change", changed);
    this.once = new OnceMore(this.radios);
  }

  get value() {
    return this.radios.find((radio) => radio.checked)?.value ?? null;
  }

  /** @returns {string} the words of the option */
  get said() {
    const radio = this.radios.find((one) => one.checked);
    return radio?.closest("label")?.textContent?.trim() ?? "";
  }

  set value(value) {
    for (const radio of this.radios) radio.checked = radio.value === value;
  }

  /** @param {boolean} on */
  enable(on) {
    for (const radio of this.radios) radio.disabled = !on;
  }

  problem() {
    return this.value === null ? tr("Choose one first.") : null;
  }

  compare() {
    return [html("p", "", tr("You said: “{said}”", { said: this.said }))];
  }
}

export class WordsForm {
  /** @param {HTMLElement} root @param {() => void} changed */
  constructor(root, changed) {
    this.box = /** @type {HTMLTextAreaElement} */ (need(root, ".carts-words"));
    this.box.addEventListener("input", changed);
  }

  get value() {
    return this.box.value;
  }

  /** @returns {string} */
  get said() {
    return this.box.value.trim();
  }

  set value(value) {
    this.box.value = String(value ?? "");
  }

  /** @param {boolean} on */
  enable(on) {
    this.box.disabled = !on;
  }

  problem() {
    return this.box.value.trim()
      ? null
      : tr("Write your prediction first; a few words are enough.");
  }

  compare() {
    return [html("p", "", tr("Compare what you saw with what you wrote."))];
  }
}
