/** The mark of an element whose numbers Python computes: whether it is there. */

import { tr } from "../language.js";
import { html } from "../markup.js";

export const liveMark = () =>
  html`<span class="carts-mark" role="img" aria-label=${tr("not live yet")}><span class="carts-mark-text" aria-hidden="true">${tr("live")}</span></span>`;
