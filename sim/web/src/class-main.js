/** The script of the page “Class results”: Python with questions and statistics, and its element. */

import { classElement } from "./class/element.js";
import { Client } from "./client.js";
import { missingFeatures } from "./features.js";
import { startRuntime } from "./runtime.js";

const own =
  /** @type {HTMLScriptElement | null} */ (document.currentScript)?.src ?? document.baseURI;
const CLASSROOM = "newtons-carts-class";

const missing = missingFeatures();
if (missing.length) {
  for (const place of document.querySelectorAll("carts-class")) {
    place.textContent = `This browser is too old to read the files (missing: ${missing.join(", ")}); Chrome or Edge 111, Firefox 113, Safari 16.4 or newer can. On the command line “carts class” does the same.`;
  }
} else {
  const base = new URL("runtime/", own).href;
  const client = new Client((more) => startRuntime({ base, packages: [CLASSROOM, ...more] }));
  customElements.define("carts-class", classElement(client));
  if (typeof requestIdleCallback === "function") {
    requestIdleCallback(() => client.wake(), { timeout: 1000 });
  } else setTimeout(() => client.wake(), 200);
}
