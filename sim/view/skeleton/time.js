/** Everything that moves the time: the scrubber with its axis, buttons, speed, clocks. */

import { tr } from "../language.js";
import { html } from "../markup.js";

/** @typedef {import("../types.js").Baked} Baked */

const LONG = 60; // s; a longer run opens faster
const SPEEDS = [1, 10, 100];
const START = "M3 3v10M13 3L6 8l7 5z";
const BACK = "M12.5 3v10M10 3L3 8l7 5z";
const FORWARD = "M3.5 3v10M6 3l7 5-7 5z";

/** @param {Baked} baked */
export function timeline({ run: { header } }) {
  return html`<div class="carts-timeline">
<svg class="carts-ticks" width="100%" height="34" aria-hidden="true"><g data-part="contacts"></g><g data-part="events"></g><g data-part="numbers"></g></svg>
<input type="range" class="carts-scrub" min="0" max=${header.until} step="any" value="0" aria-label=${tr("Time")} disabled>
</div>`;
}

/** @param {Baked} baked */
export function transport({ fence, run: { header } }) {
  const slow = fence.slow !== "never" && header.contacts.some(({ stiffness }) => stiffness);
  const speed = openingSpeed(header.until);
  const speeds = SPEEDS.map(
    (n) => html`<option value=${n}${n === speed && html` selected`}>${n}×</option>`,
  );
  return html`<div class="carts-transport">
${button("start", START, tr("Back to the start"), tr("Back to the start (Home)"))}
${button("back", BACK, tr("Step back"), tr("Step back (left arrow key)"))}
<button type="button" class="carts-button carts-play" title=${tr("Play or pause (space bar)")} disabled><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path class="carts-icon-play" d="M4 2.5L13 8l-9 5.5z"/><path class="carts-icon-pause" d="M4 3h3v10H4zM9 3h3v10H9z"/></svg><span>${tr("Play")}</span></button>
${button("forward", FORWARD, tr("Step forward"), tr("Step forward (right arrow key)"))}
<label class="carts-speed-label">${tr("Speed")} <select autocomplete="off" class="carts-speed" disabled><option value="0.01">1/100</option><option value="0.1">1/10</option>${speeds}</select></label> <a class="carts-jump carts-down" href="#${fence.id}-graphs">${tr("Graphs")} ↓</a>
${slow && html`<label class="carts-slow-label"><input type="checkbox" class="carts-slow" checked disabled> ${tr("slow motion in contacts")}</label>`}
<p class="carts-clocks"><span>${tr("cart time")} <span class="carts-clock">0.000</span> s</span>${slow && html`<span class="carts-slow-note" aria-hidden="true"><b class="carts-rate">1×</b> ${tr("speed, your time")} <span class="carts-own-clock">0.0</span> s</span>`}</p>
${fence.watch === "first" && html`<button type="button" class="carts-button carts-end" disabled>${tr("Show me the end")}</button>`}
</div>`;
}

/** @param {string} name @param {string} icon path @param {string} label @param {string} title */
function button(name, icon, label, title) {
  return html`<button type="button" class="carts-button carts-${name}" aria-label=${label} title=${title} disabled><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d=${icon}/></svg></button>`;
}

/** The speed at which a long run is seen in 6 to 60 s; at most a hundredfold. @param {number} until in s */
function openingSpeed(until) {
  if (until <= LONG) return 1;
  return until >= 10 * LONG ? 100 : 10;
}
