/** The script of pages with readings of real carts: Python with what reads and fits them, and its element. */

import { measuredElement } from "./measured/element.js";
import { pagePython, startWhenIdle } from "./runtime/page-python.js";
import { missingFeatures } from "./shared/features.js";

const MEASURED = "newtons-carts-measured";

const script = /** @type {HTMLScriptElement | null} */ (document.currentScript);
const missing = missingFeatures();
if (missing.length) {
  for (const note of document.querySelectorAll("carts-measured .carts-note")) {
    /** @type {HTMLElement} */ (note).hidden = false;
    note.textContent = `This browser is too old to fit the readings (missing: ${missing.join(", ")}); Chrome or Edge 103, Firefox 113, Safari 16.4 or newer can. On the command line “carts fit” does the same.`;
  }
} else {
  const client = pagePython(() => [MEASURED]);
  const base = script?.src || document.baseURI;
  customElements.define("carts-measured", measuredElement(client, base));
  startWhenIdle(client);
}
