/** The further sliders of a map follow what a program has set; what a reader typed stays as typed. */

import { decimalsOf, fixed } from "../../../view/numbers.js";
import { need } from "../shared/dom.js";

/**
 * @param {HTMLElement} map @param {import("../../../view/types.js").Control[]} controls
 * @param {Record<string, number | string>} settings SI numbers, or text with a unit
 */
export function showSettings(map, controls, settings) {
  for (const { set, per, step } of controls) {
    const value = settings[set];
    const root = map.querySelector(`.carts-control[data-set="${CSS.escape(set)}"]`);
    if (typeof value !== "number" || !root) continue;
    const shown = Number((value / per).toPrecision(12));
    const box = /** @type {HTMLInputElement} */ (need(root, ".carts-number-box"));
    /** @type {HTMLInputElement} */ (need(root, ".carts-slider")).valueAsNumber = shown;
    if (box !== document.activeElement) {
      const decimals = Math.max(decimalsOf(shown), decimalsOf(step));
      box.value = fixed(shown, decimals).replace("−", "-");
    }
  }
}

/** The button by which a map is opened, and what is said beside it. @param {HTMLElement} map @param {boolean} on */
export function offerOpening(map, on) {
  const button = /** @type {HTMLButtonElement} */ (need(map, ".carts-map-open"));
  button.disabled = !on;
  for (const part of [button, need(map, ".carts-map-wait")]) part.hidden = !on;
}

/** @param {HTMLElement} map @param {number} done @param {number} runs */
export function showProgress(map, done, runs) {
  const bar = /** @type {HTMLProgressElement} */ (need(map, ".carts-map-progress"));
  bar.value = done / runs;
  bar.style.visibility = done < runs ? "visible" : "hidden";
}
