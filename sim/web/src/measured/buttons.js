/** The buttons of a bench: what is read, fitted, and taken along. */

import { told } from "../../../view/language.js";
import { need } from "../shared/dom.js";
import { download } from "../shared/download.js";
import { printWith } from "../shared/printing.js";

/** @typedef {import("../../../view/measured/types.js").Report} Report */
/**
 * @typedef {{own: () => void, save: () => void, fit: () => void, compare: () => void,
 *   tracker: () => Promise<{text?: string}>, early: () => void}} Acts early: a fit may come
 */

/** @param {HTMLElement & {report: Report | null}} bench @param {Acts} acts */
export function wireButtons(bench, { own, save, fit, compare, tracker, early }) {
  const on = (/** @type {string} */ name, /** @type {() => void} */ act) =>
    bench.querySelector(`.carts-measured-${name}`)?.addEventListener("click", act);
  on("own", own);
  on("save", save);
  on("fit", fit);
  on("compare", compare);
  on("scene", () => download("real-carts.yml", told(bench.report?.scene ?? ""), "text/yaml"));
  on("tracker", async () => {
    const { text } = await tracker();
    if (text) download("model-run.txt", text, "text/plain;charset=utf-8");
  });
  on("print", () => {
    bench.dataset.printing = ""; // alone, without the lesson around it
    printWith(() => delete bench.dataset.printing);
  });
  const model = need(bench, ".carts-measured-model");
  for (const kind of ["pointerdown", "focusin"])
    model.addEventListener(kind, early, { once: true });
}
