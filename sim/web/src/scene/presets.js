/** Ready-made settings: which of them is on screen, which were watched. A reader who pressed four shall see both. */

import { whatIs } from "../../../view/bodies.js";
import { inRow, tr } from "../../../view/language.js";
import { put, say } from "../shared/dom.js";
import { valueIn } from "./controls.js";

/** @typedef {import("./values.js").Settings} Settings */

export class Presets {
  /** @type {Set<string>} those whose run was seen to its end */
  #seen = new Set();

  /** @param {HTMLElement} root @param {import("../../../view/types.js").Fence} fence @param {(changes: Settings, name: string) => void} choose */
  constructor(root, fence, choose) {
    this.presets = fence.presets;
    this.numbers = fence.presetNumbers;
    /** @type {NodeListOf<HTMLElement>} */
    this.buttons = root.querySelectorAll(".carts-preset");
    this.line = root.querySelector(".carts-presets-left");
    for (const button of this.buttons) {
      button.addEventListener("click", () => {
        choose(this.#of(button), button.dataset.preset ?? "");
      });
    }
  }

  get names() {
    return Object.keys(this.presets);
  }

  /** @returns {string[]} those whose values the run on the page has */
  get pressed() {
    return [...this.buttons]
      .filter((button) => button.getAttribute("aria-pressed") === "true")
      .map((button) => button.dataset.preset ?? "");
  }

  /** @returns {string[]} those that were not watched yet */
  get left() {
    return this.names.filter((name) => !this.#seen.has(name));
  }

  /** @param {HTMLElement} button @returns {Settings} */
  #of(button) {
    return this.presets[button.dataset.preset ?? ""] ?? {};
  }

  /** @param {Settings} settings those of the run on screen @param {import("../../../view/types.js").Header} header */
  show(settings, header) {
    for (const button of this.buttons) {
      const values = Object.entries(this.#of(button));
      const numbers = this.numbers[button.dataset.preset ?? ""];
      const asked = values.every(([target, value]) => settings[target] === value);
      // Before anything was pressed: what the lesson begins with may be one of them.
      const same = values.every(([target, value]) => {
        const what = thingIn(header, target);
        return what ? what === value : valueIn(header, target) === numbers?.[target];
      });
      put(button, "aria-pressed", String(values.length > 0 && (asked || same)));
    }
  }

  /** @param {string[]} names whose runs were seen to their end */
  seen(names) {
    for (const name of names) this.#seen.add(name);
    if (!this.line) return; // nothing of this scene waits
    for (const button of this.buttons) {
      button.toggleAttribute("data-seen", this.#seen.has(button.dataset.preset ?? ""));
    }
    if (!this.#seen.size) return;
    const left = inRow(this.left);
    say(this.line, left ? tr("Still to watch: {names}", { names: left }) : tr("All watched."));
  }
}

/** What a run says stands at an end of the track; "" for another target. @param {import("../../../view/types.js").Header} header @param {string} target */
function thingIn({ track }, target) {
  const side = /^track\.(left|right)_is$/.exec(target)?.[1];
  return side ? whatIs(side, track) : "";
}
