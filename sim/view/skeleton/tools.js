/**
 * Tools that a reader works: a stopwatch that counts the carts' time, and a ruler whose two ends are laid
 * against the picture. Only in scenes that name them (`with: [ruler, stopwatch]`).
 */

import { tr } from "../language.js";
import { html } from "../markup.js";
import { decimalsOf, fixed, px } from "../numbers.js";
import { niceAbove } from "../scales.js";

/** @typedef {import("../types.js").Baked} Baked */
/** @typedef {import("../types.js").Layout} Layout */

const STEPS = 500; // of the ruler, over the picture: about a pixel
const AT_FIRST = [0.25, 0.5]; // of the picture: where the ends lie
const HANDLE = 8; // units, radius

/** @param {Baked} baked */
export function tools({ fence, view }) {
  const layout = view.layouts[0];
  const watch = fence.opened.includes("stopwatch");
  if (!layout?.tape && !watch) return null;
  return html`<div class="carts-tools">
${watch && stopwatch()}
${layout && layout.tape > 0 && ruler(layout)}
</div>`;
}

function stopwatch() {
  const name = tr("Stopwatch");
  return html`<div class="carts-tool" role="group" aria-label=${name} data-tool="stopwatch"><span class="carts-heading">${name}</span> <span class="carts-tool-read"><output aria-live="off">0.00</output> s</span> <button type="button" class="carts-button" data-act="stop" data-stop=${tr("Stop")} data-start=${tr("Start")}>${tr("Start")}</button> <button type="button" class="carts-button" data-act="zero">${tr("Zero")}</button></div>`;
}

/** @param {Layout} layout */
function ruler(layout) {
  const name = tr("Ruler");
  const step = stepOf(layout);
  const decimals = decimalsOf(step);
  const [from, to] = ends(layout);
  const end = (/** @type {string} */ key, /** @type {string} */ label, /** @type {number} */ x) =>
    html`<input type="range" data-end=${key} min=${px(layout.low, decimals)} max=${px(layout.high, decimals)} step=${step} value=${px(x, decimals)} autocomplete="off" aria-label=${label} aria-valuetext="${fixed(x, decimals)} m">`;
  return html`<div class="carts-tool" role="group" aria-label=${name} data-tool="ruler" data-decimals=${decimals}><span class="carts-heading">${name}</span> ${end("from", tr("left end of the ruler"), from)}${end("to", tr("right end of the ruler"), to)} <span class="carts-tool-read"><output>${fixed(to - from, decimals)}</output> m</span></div>`;
}

/** The ruler in the picture: two lines down through the carts, a tape between them. @param {Layout} layout */
export function tape(layout) {
  const at = (/** @type {number} */ x) => px(layout.origin + x * layout.scale);
  const [from, to] = ends(layout);
  const y = px(layout.tape);
  const numbers = layout.track + layout.beam; // the line leaves them free, where they stand
  const line = `M0 ${px(layout.track - 36)}V${px(numbers + 8)}M0 ${px(numbers + 27)}V${y}`;
  const end = (/** @type {string} */ key, /** @type {number} */ x) =>
    html`<g class="carts-tape-end" data-end=${key} transform="translate(${at(x)} 0)"><path d=${line}/><circle class="carts-pull-room" cx="0" cy=${y} r="16"/><circle cx="0" cy=${y} r=${HANDLE}/></g>`;
  const middle = at((from + to) / 2);
  return html`<g class="carts-tape" data-origin=${px(layout.origin, 4)} data-scale=${px(layout.scale, 4)} data-y=${y}><path data-part="tape" d="M${at(from)} ${y}H${at(to)}"/>${end("from", from)}${end("to", to)}<text data-part="length" x=${middle} y=${px(layout.tape + 5)} text-anchor="middle">${fixed(to - from, decimalsOf(stepOf(layout)))} m</text></g>`;
}

/** @param {Layout} layout @returns {number} m, to which the ruler reads */
function stepOf({ low, high }) {
  return niceAbove((high - low) / STEPS);
}

/** @param {Layout} layout @returns {[number, number]} m, where its ends lie at first: on a whole step */
function ends(layout) {
  const { low, high } = layout;
  const step = stepOf(layout);
  const [from, to] = AT_FIRST.map((part) => Math.round((low + part * (high - low)) / step) * step);
  return [from ?? low, to ?? high];
}
