/** The script of pages on which a reader writes a law: an editor, a Python of its own, and a judge. */

import "./shared/older.js";
import { lawElement } from "./law/element.js";

const script = /** @type {HTMLScriptElement | null} */ (document.currentScript);
const own = new URL(script?.src || document.baseURI);
customElements.define("carts-law", lawElement(new URL(`runtime/${own.search}`, own).href));
