/** The time in the film: a slider for the long ways; its arrow keys, and two buttons, go on by single frames. */

import { fixed } from "../../../view/numbers.js";
import { need, say } from "../shared/dom.js";

const STEPS = /** @type {Record<string, number>} */ ({
  ArrowLeft: -1,
  ArrowDown: -1,
  ArrowRight: 1,
  ArrowUp: 1,
});

export class Scrub {
  /** @param {HTMLElement} root @param {(step: number) => void} moved so many frames on; 0: to where the slider is */
  constructor(root, moved) {
    this.clock = need(root, ".carts-film-clock");
    this.slider = /** @type {HTMLInputElement} */ (need(root, ".carts-film-time"));
    this.slider.addEventListener("input", () => moved(0));
    this.slider.addEventListener("keydown", (event) => {
      const step = STEPS[event.key];
      const { altKey, ctrlKey, metaKey } = event;
      if (!step || altKey || ctrlKey || metaKey) return; // Home, End and whole pages are the slider's own
      event.preventDefault();
      moved(step);
    });
    this.buttons = ["back", "on"].map((name, k) => {
      const button = /** @type {HTMLButtonElement} */ (need(root, `.carts-film-${name}`));
      button.addEventListener("click", () => moved(2 * k - 1));
      return button;
    });
  }

  /** @param {{begin: number, end: number}} film s */
  reach({ begin, end }) {
    Object.assign(this.slider, { min: begin, max: end, value: begin });
  }

  /** @param {boolean} off */
  set disabled(off) {
    for (const one of [this.slider, ...this.buttons]) one.disabled = off;
  }

  get time() {
    return this.slider.valueAsNumber;
  }

  /** @param {number} time s, of the frame that is shown @param {boolean} ahead whether the slider is where the next frame will be */
  show(time, ahead = false) {
    if (!ahead) this.slider.value = String(time);
    const clock = `${fixed(time, 3)} s`;
    this.slider.setAttribute("aria-valuetext", clock);
    say(this.clock, clock);
  }
}
