/** A graph against time before anything is drawn in it: its frame, its name, its table. */

import { sizeName } from "../effects-words.js";
import { BOTTOM, HEIGHT, LEFT, RIGHT, TOP, WIDTH } from "../graph.js";
import { tr } from "../language.js";
import { html } from "../markup.js";
import { speedUnit } from "../numbers.js";
import { lower, QUANTITIES } from "../words.js";

/** @typedef {import("../types.js").Baked} Baked */
/** @typedef {import("../markup.js").Markup} Markup */

const WITH_SIGN = html` <button type="button" class="carts-sign" aria-pressed="false" disabled title=${tr("Show the direction: + means to the right")}>${tr("with sign")}</button>`;
const LEDGER = html` <button type="button" class="carts-sign carts-stack" aria-pressed="false" disabled title=${tr("Kinetic energy, squeezed bumpers and warmth on top of each other")}>${tr("as a ledger")}</button>`;

/** @type {Record<string, Markup>} a button of its own */
const TOGGLES = { F: WITH_SIGN, energy: LEDGER };

/** @param {Baked} baked @param {string} quantity @returns {Markup} */
export function graph({ fence, view, run }, quantity) {
  const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", "", ""];
  const isForce = quantity === "F";
  const name = isForce ? sizeName(run.header) : title;
  const camera = fence.camera && ["x", "v"].includes(quantity) ? tr("seen from the camera, ") : "";
  const measured = quantity === "v" ? speedUnit(view.velocity)[1] : unit;
  const label = tr("{quantity} against time", { quantity: name });
  const table = tr("Table: {quantity}", { quantity: lower(name) });
  return html`<div class="carts-graph" data-quantity=${quantity} role="group" aria-label=${label}>
<p class="carts-graph-title"><span class="carts-graph-name">${name} ${camera}<i>${isForce ? "|F|" : symbol}</i>${tr(" in {unit}", { unit: measured })}</span>${TOGGLES[quantity]}</p>
${plot(`${fence.id}-${quantity}-clip`, isForce, fence.watch === "first")}
<p class="carts-key"></p>
${isForce && html`<p class="carts-area-note carts-quiet">\u00a0</p>`}
<details class="carts-more"><summary>${table}</summary>
<div class="carts-scroll"><table class="carts-table"><thead><tr><th scope="col">${tr("t in s")}</th></tr></thead><tbody></tbody></table></div></details>
</div>`;
}

/** @param {string} clip id @param {boolean} isForce @param {boolean} growing whether areas grow with the clock */
function plot(clip, isForce, growing) {
  const inside = html`clip-path="url(#${clip})"`;
  const shade = html`<path class="carts-impulse" d=""/>`;
  const room = html`<rect x=${LEFT} y=${TOP - 4} width=${RIGHT - LEFT + 1} height=${BOTTOM - TOP + 8}/>`;
  const seen = `${clip}-seen`;
  return html`<svg class="carts-plot" viewBox="0 0 ${WIDTH} ${HEIGHT}" width=${WIDTH} height=${HEIGHT} aria-hidden="true">
<defs><clipPath id=${clip}>${room}</clipPath>${growing && html`<clipPath id=${seen} class="carts-seen">${room}</clipPath>`}</defs>
<g data-part="times"></g>
<g data-part="values"></g>
<text class="carts-unit" x=${RIGHT} y=${HEIGHT - 3} text-anchor="end">${tr("time t in s")}</text>
<g data-part="areas" clip-path="url(#${growing ? seen : clip})">${isForce && [shade, shade]}</g>
<g data-part="curves" ${inside}></g>
<g data-part="cursor" ${inside}><path class="carts-cursor" d="M0 ${TOP}V${BOTTOM}" transform="translate(${LEFT} 0)"/></g>
</svg>`;
}
