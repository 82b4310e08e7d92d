/** Ready-made settings: which of them is on screen. A reader who pressed four shall see which this is. */

import { put } from "../shared/dom.js";
import { valueIn } from "./controls.js";

/** @typedef {import("./values.js").Settings} Settings */

export class Presets {
  /** @param {HTMLElement} root @param {Record<string, Settings>} presets @param {(changes: Settings) => void} choose */
  constructor(root, presets, choose) {
    this.presets = presets;
    /** @type {NodeListOf<HTMLElement>} */
    this.buttons = root.querySelectorAll(".carts-preset");
    for (const button of this.buttons) {
      button.addEventListener("click", () => choose(this.#of(button)));
    }
  }

  /** @param {HTMLElement} button @returns {Settings} */
  #of(button) {
    return this.presets[button.dataset.preset ?? ""] ?? {};
  }

  /** @param {Settings} settings those of the run on screen @param {import("../../../view/types.js").Header} header */
  show(settings, header) {
    for (const button of this.buttons) {
      const values = Object.entries(this.#of(button));
      const asked = values.every(([target, value]) => settings[target] === value);
      // Before anything was pressed: what the lesson begins with may be one of them, in its own units.
      const same = values.every(
        ([target, value]) => valueIn(header, target) === Number.parseFloat(String(value)),
      );
      put(button, "aria-pressed", String(values.length > 0 && (asked || same)));
    }
  }
}
