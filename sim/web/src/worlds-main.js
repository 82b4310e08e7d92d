/** The script of pages whose scenes name worlds that do not exist. The scene's own Python runs them. */

import { WorldsElement } from "./worlds/element.js";

customElements.define("carts-worlds", WorldsElement);
