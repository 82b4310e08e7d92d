/**
 * Readings of real carts as they stand in the page. Without a script the points and their table are all there
 * is; what the script fills in has its place already, so that nothing jumps.
 */

import { counted, tr } from "../language.js";
import { html } from "../markup.js";
import { liveMark } from "../skeleton/mark.js";
import { tableOf } from "./table.js";
import { howRead, semicolons } from "./units.js";

/** @typedef {import("./types.js").Facts} Facts */
/** @typedef {import("../markup.js").Markup} Markup */

const MOST_ROWS = 60; // of the table without a script; the page's script fills in all
const UNITS = /** @type {const} */ ([
  ["length", () => tr("lengths are in")],
  ["time", () => tr("times are in")],
  ["force", () => tr("forces are in")],
]);
/** @type {[string, () => string, string][]} */
const HANDS = [
  ["touch", () => tr("first touch at"), "s"],
  ["va", () => tr("velocity of {cart} before", { cart: "A" }), "m/s"],
  ["vb", () => tr("velocity of {cart} before", { cart: "B" }), "m/s"],
  ["ratio", () => tr("mass of {b} ÷ mass of {a}", { a: "A", b: "B" }), ""],
  ["e", () => tr("bounciness e"), ""],
  ["duration", () => tr("the contact lasts"), "s"],
];

const SIGNED = ["touch", "va", "vb"]; // a phone's keys for decimals lack a minus

/** The contact laws that are fitted. @type {Record<string, () => string>} */
const LAWS = { bumper: () => tr("bumper"), paper: () => tr("paper") };

/** @param {Facts} facts @returns {Markup} the inside of `<carts-measured>`; its figure is still empty */
export function inside(facts) {
  const { id, title } = facts;
  const hint = html`<text class="carts-measured-hint" x="320" y="130" text-anchor="middle">${tr("Open a file or a film, drop it here, or type readings.")}</text>`;
  return html`<div class="carts-measured-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
${source(facts)}
<div class="carts-measured-world" hidden><svg class="carts-measured-stage" viewBox="0 0 640 96" width="640" height="96" role="img" aria-label=${tr("the model’s carts; rings are the measured places")}></svg>
<div class="carts-transport carts-measured-transport"><button type="button" class="carts-button carts-play carts-measured-play">${tr("Play")}</button><input type="range" class="carts-measured-scrub" min="0" max="1" step="any" value="0" aria-label=${tr("time")}><span class="carts-measured-clock"></span></div></div>
<div class="carts-measured-figures">
<p class="carts-measured-legend"></p>
<div class="carts-measured-spans" hidden></div>
<svg class="carts-measured-figure" viewBox="0 0 640 284" width="640" height="284" role="img" aria-label=${tr("readings over time; the numbers are in the table below")}>${!facts.read && hint}</svg>
<svg class="carts-measured-left" viewBox="0 0 640 134" width="640" height="134" role="img" aria-label=${tr("residuals: measured minus model")} hidden></svg>
<p class="carts-measured-spread" role="status"></p>
</div>
${model(facts)}
<div class="carts-measured-result" hidden></div>
<div class="carts-measured-back" hidden>
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-scene">${tr("Save the fitted scene")}</button> <button type="button" class="carts-button carts-measured-tracker">${tr("Save the model’s run for Tracker")}</button> <button type="button" class="carts-button carts-measured-print">${tr("Print this alone")}</button></p>
<details class="carts-more"><summary>${tr("The fitted scene as a block of a lesson")}</summary><textarea class="carts-measured-fence" rows="10" readonly spellcheck="false" aria-label=${tr("block of a lesson")}></textarea></details>
</div>
${table(facts)}
<noscript><p class="carts-noscript">${tr("The readings are shown. Fitting them here needs JavaScript; on the command line “carts fit” does the same.")}</p></noscript>
</div>`;
}

/** Where readings come from. @param {Facts} facts */
function source({ name, units, offered, read }) {
  const choices = UNITS.map(([kind, text], k) => {
    const options = offered[kind].map(
      (unit) =>
        html`<option value=${unit}${units?.[kind] === unit && html` selected`}>${unit}</option>`,
    );
    const said = read && !read.assumed.some((one) => one === kind) && html` hidden`;
    return html`${k > 0 && " "}<label${said}>${text()} <select autocomplete="off" class="carts-measured-unit" data-kind=${kind} disabled><option value="">${tr("choose …")}</option>${options}</select></label>`;
  });
  const own = html`<button type="button" class="carts-button carts-measured-own" disabled>${tr("The lesson’s readings")}</button> `;
  return html`<div class="carts-measured-source">
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-open" disabled>${tr("Open a file")}</button><input type="file" class="carts-measured-file" accept=".txt,.csv,.tsv,.trk,.trz,.zip,text/plain,text/csv,application/zip" multiple hidden tabindex="-1" aria-label=${tr("files with readings")}> ${film()}${name && own}<button type="button" class="carts-button carts-measured-save" disabled>${tr("Save these readings")}</button></p>
<details class="carts-more carts-measured-paste"><summary>${tr("Paste readings")}</summary><label>${tr("Text from Tracker, a spreadsheet or a sensor")} <textarea rows="6" spellcheck="false" autocomplete="off" disabled></textarea></label><p class="carts-measured-row"><button type="button" class="carts-button carts-measured-take" disabled>${tr("Read this text")}</button></p></details>
<details class="carts-more carts-measured-type"><summary>${tr("Type readings")}</summary><div class="carts-scroll" role="group" aria-label=${tr("table to type readings into")}><table class="carts-table carts-measured-grid"><thead><tr><th scope="col">t</th><th scope="col">${tr("{letter} of {cart}", { letter: "x", cart: "A" })}</th><th scope="col">${tr("{letter} of {cart}", { letter: "x", cart: "B" })}</th></tr></thead><tbody></tbody></table></div><p class="carts-measured-row"><button type="button" class="carts-button carts-measured-more" disabled>${tr("More rows")}</button> <button type="button" class="carts-button carts-measured-typed-take" disabled>${tr("Read this table")}</button></p></details>
<p class="carts-measured-row">${choices}</p>
<p class="carts-measured-row"><label class="carts-measured-runs" hidden>${tr("run")} <select autocomplete="off" class="carts-measured-run"></select></label> <label>${tr("use readings from")} <input type="text" autocomplete="off" class="carts-measured-from" disabled> s</label> <label>${tr("until")} <input type="text" autocomplete="off" class="carts-measured-until" disabled> s</label></p>
<p class="carts-measured-said" role="status">${name && `${name}: ${read ? semicolons(howRead(read)) : ""}`}</p>
<div role="alert"><ul class="carts-measured-faults carts-measured-unread"></ul></div>
</div>`;
}

/** Films are opened by a script of their own; a phone offers its camera here. */
function film() {
  return html`<button type="button" class="carts-button carts-measured-film" disabled>${tr("Choose a film")}</button><input type="file" class="carts-measured-film-file" accept="video/*,.mp4,.m4v,.mov,.webm" hidden tabindex="-1" aria-label=${tr("film of the carts")}> <button type="button" class="carts-button carts-measured-camera" hidden disabled>${tr("Film with the camera")}</button> `;
}

/** The model by hand, and what a fit may ask for. @param {Facts} facts */
function model({ id, law }) {
  const hands = HANDS.map(
    ([key, text, unit]) =>
      html`<div class="carts-measured-hand" data-hand=${key}><label for="${id}-${key}">${text()}</label><input type="range" class="carts-measured-slide" aria-label=${text()} disabled><span class="carts-measured-typed"><input type="text" id="${id}-${key}" inputmode=${SIGNED.includes(key) ? "text" : "decimal"} autocomplete="off" disabled> ${unit}</span></div>`,
  );
  const laws = Object.entries(LAWS).map(
    ([name, text]) =>
      html`<option value=${name}${law === name && html` selected`}>${text()}</option>`,
  );
  return html`<div class="carts-measured-model" hidden>
<p class="carts-heading">${tr("Set the model by hand, or let it be fitted")}</p>
<div class="carts-measured-hands">${hands}</div>
<p class="carts-measured-row"><label>${tr("contact law")} <select autocomplete="off" class="carts-measured-law">${laws}</select></label> <label>${tr("fit also")} <select autocomplete="off" class="carts-measured-effect"><option value="none">${tr("nothing else")}</option><option value="friction">${tr("friction of each cart")}</option><option value="tilt">${tr("a tilt of the track")}</option><option value="both">${tr("friction and a tilt")}</option><option value="called">${tr("what the readings call for")}</option></select></label></p>
<p class="carts-measured-row carts-measured-masses carts-measured-rare"></p>
<p class="carts-measured-row carts-measured-rare"><label>${tr("marks are apart, when the bumpers just touch:")} <input type="text" inputmode="decimal" autocomplete="off" class="carts-measured-distance"> m</label> <span class="carts-quiet">${tr("if you know it")}</span></p>
<p class="carts-measured-row carts-measured-rare"><label><input type="checkbox" class="carts-measured-together"> ${tr("I saw that the carts stayed together")}</label> <span class="carts-quiet">${tr("where a sensor lost one of them")}</span></p>
<div role="alert"><ul class="carts-measured-faults carts-measured-unfitted"></ul></div>
<p class="carts-measured-row"><button type="button" class="carts-button carts-measured-fit">${tr("Fit the model")}</button> <button type="button" class="carts-button carts-measured-compare">${tr("Compare with friction and tilt")}</button> <span class="carts-measured-busy" role="status"></span></p>
</div>`;
}

/** @param {Facts} facts */
function table({ read }) {
  const { head, rows } = read ? tableOf(read, null) : { head: [], rows: [] };
  const heads = head.map((cell) => html`<th scope="col">${cell}</th>`);
  const lines = rows
    .slice(0, MOST_ROWS)
    .map((row) => html`<tr>${row.map((cell) => html`<td>${cell}</td>`)}</tr>`);
  const more = rows.length - lines.length;
  return html`<details class="carts-more carts-measured-table"><summary>${tr("Table of the readings")}</summary><div class="carts-scroll" role="group" tabindex="0" aria-label=${tr("readings")}><table class="carts-table"><thead><tr>${heads}</tr></thead><tbody>${lines}</tbody></table></div>${more > 0 && html`<p class="carts-measured-rest">${counted("and 1 more row", "and {n} more rows", more)}</p>`}</details>`;
}
