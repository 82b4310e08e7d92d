/** What a browser must have to run Python in the page. Without it the baked page stays as it is. */

import { tr } from "../../../view/language.js";

/** @returns {string[]} names of what is missing */
export function missingFeatures() {
  /** @type {[string, boolean][]} */
  const needed = [
    [tr("custom elements"), typeof customElements === "object"],
    ["WebAssembly", typeof WebAssembly === "object"],
    [tr("workers"), typeof Worker === "function"],
    [tr("decompression"), typeof DecompressionStream === "function"],
    [tr("array methods"), typeof Array.prototype.findLast === "function"],
    [
      tr("container queries"),
      typeof CSS === "object" && CSS.supports("container-type: inline-size"),
    ],
  ];
  return needed.filter(([, there]) => !there).map(([name]) => name);
}

/** @param {Element} scene @param {string[]} missing */
export function excuse(scene, missing) {
  const note = scene.querySelector(".carts-note");
  if (!(note instanceof HTMLElement)) return;
  note.hidden = false;
  note.textContent = tr(
    "This browser is too old to play the run (missing: {features}); Chrome or Edge 111, Firefox 113, Safari 16.4 or newer can.",
    { features: missing.join(", ") },
  );
}
