/** The script of the page “Class results”: Python with questions and statistics, and its element. */

import { tr } from "../../view/language.js";
import { classElement } from "./class/element.js";
import { pagePython, startWhenIdle } from "./runtime/page-python.js";
import { missingFeatures } from "./shared/features.js";

const CLASSROOM = "newtons-carts-class";

const missing = missingFeatures();
if (missing.length) {
  for (const place of document.querySelectorAll("carts-class")) {
    place.textContent = tr(
      "This browser is too old to read the files (missing: {missing}); Chrome or Edge 103, Firefox 113, Safari 16.4 or newer can. On the command line “carts class” does the same.",
      { missing: missing.join(", ") },
    );
  }
} else {
  const client = pagePython(() => [CLASSROOM]);
  customElements.define("carts-class", classElement(client));
  startWhenIdle(client);
}
