/** The film in the page, before its first frame is there. */

import { tr } from "../../../view/language.js";
import { html } from "../../../view/markup.js";

/** @typedef {import("../../../view/markup.js").Markup} Markup */

/** @param {string} id of the block of readings @returns {Markup} */
export function inside(id) {
  const arrows = tr("Arrow keys move the cross, with Shift by single pixels; Enter sets it.");
  return html`<section class="carts-film" aria-label=${tr("The film")}>
<p class="carts-film-say" role="status"></p>
<canvas class="carts-film-view" width="640" height="360" tabindex="0" role="application" aria-label=${tr("frame of the film")} aria-describedby="${id}-film-keys"></canvas>
<p class="carts-hidden" id="${id}-film-keys">${arrows}</p>
<p class="carts-film-row"><input type="range" class="carts-film-time" min="0" max="1" step="any" value="0" aria-label=${tr("time in the film")} disabled><span class="carts-film-clock"></span><span><button type="button" class="carts-button carts-film-back" disabled>${tr("One frame back")}</button> <button type="button" class="carts-button carts-film-on" disabled>${tr("One frame on")}</button></span></p>
<p class="carts-film-row carts-film-aims" role="group" aria-label=${tr("what the next click sets")}>${aims()}</p>
${settings()}
<p class="carts-film-row carts-film-acts"><button type="button" class="carts-button carts-film-follow" disabled>${tr("Follow")}</button> <button type="button" class="carts-button carts-film-cancel" hidden>${tr("Cancel")}</button><progress class="carts-film-part" max="1" value="0" aria-label=${tr("how much of the film is followed")} hidden></progress></p>
${mending()}
</section>`;
}

function aims() {
  const named = [
    ["A", tr("mark of cart {name}", { name: "A" })],
    ["B", tr("mark of cart {name}", { name: "B" })],
    ["one", tr("one end of the ruler")],
    ["other", tr("other end of the ruler")],
  ];
  return named.map(
    ([aim, text]) =>
      html`<button type="button" class="carts-button" data-aim=${aim} aria-pressed="false" disabled>${text}</button> `,
  );
}

function settings() {
  const units = ["m", "cm"].map((unit) => html`<option value=${unit}>${unit}</option>`);
  return html`<p class="carts-film-row"><label>${tr("length of the ruler")} <input type="text" class="carts-film-length" inputmode="decimal" autocomplete="off" disabled></label> <select class="carts-film-unit" aria-label=${tr("unit of the ruler’s length")} disabled>${units}</select> <label>${tr("slow motion: times slower than life")} <input type="text" class="carts-film-slower" inputmode="decimal" autocomplete="off" value="1" disabled></label></p>`;
}

function mending() {
  return html`<p class="carts-film-row carts-film-mend" hidden><button type="button" class="carts-button carts-film-next">${tr("Next lost place")}</button> <button type="button" class="carts-button carts-film-leave">${tr("Leave it out")}</button> <button type="button" class="carts-button carts-film-undo" disabled>${tr("Undo")}</button> <button type="button" class="carts-button carts-film-read">${tr("Read these places")}</button> <button type="button" class="carts-button carts-film-again">${tr("Set the marks anew")}</button></p>
<p class="carts-film-key" hidden>${tr("Rings: as measured. Crosses: the model.")}</p>`;
}
