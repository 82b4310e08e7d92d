/** The script of pages on which a reader writes a law: an editor, a Python of its own, and a judge. */

import "./shared/older.js";
import { lawElement } from "./law/element.js";
import { besideScript } from "./runtime/page-python.js";

customElements.define("carts-law", lawElement(besideScript("runtime/")));
