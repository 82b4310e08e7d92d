/** What a browser must have to run Python in the page. Without it the run that the page brought along still plays. */

import { tr } from "../../../view/language.js";

/** @returns {string[]} names of what is missing */
export function missingFeatures() {
  /** @type {[string, boolean][]} */
  const needed = [
    ["WebAssembly", typeof WebAssembly === "object"],
    [tr("workers"), typeof Worker === "function"],
    [tr("decompression"), typeof DecompressionStream === "function"],
  ];
  return needed.filter(([, there]) => !there).map(([name]) => name);
}
