/** The script of pages of a web server: at their foot, how to take a lesson home and how to keep the site. */

import { downloadLine } from "./hosted/download.js";
import { keepLine } from "./hosted/keep.js";

const { src } = /** @type {HTMLScriptElement} */ (document.currentScript);
const place = /** @type {HTMLElement | null} */ (document.querySelector(".carts-hosted"));

if (place) {
  const { shell } = place.dataset;
  if (shell) place.append(downloadLine(shell, new URL(".", src).href));
  if ("kept" in place.dataset) keepLine((line) => place.append(line));
}
