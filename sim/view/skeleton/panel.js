/**
 * Readouts and sliders: one card per cart, then the contact, the rest of the scene, and what acts.
 * Warnings stand below the sliders, so that no slider moves away under a finger when one comes or goes.
 */

import { isWord } from "../bodies.js";
import { effectOf } from "../effects.js";
import { tr } from "../language.js";
import { MARKERS, styleOf } from "../markers.js";
import { html } from "../markup.js";
import { decimalsOf, fixed, speedUnit } from "../numbers.js";

/** @typedef {import("../types.js").Baked} Baked */
/** @typedef {import("../types.js").Control} Control */

/** @param {Baked} baked */
export function panel(baked) {
  const { fence } = baked;
  const { controls, switches, presets } = fence;
  const names = Object.keys(presets);
  const buttons = names.map(
    (name) =>
      html`<button type="button" class="carts-button carts-preset" data-preset=${name} disabled>${name}</button>`,
  );
  const all = fence.watch === "first" && names.length > 1;
  const left =
    all &&
    html` <span class="carts-presets-left" role="status">${tr("Watch each of them once.")}</span>`;
  const back = controls.length || switches.length || names.length;
  return html`<div class="carts-side">
${names.length > 0 && html`<p class="carts-presets" role="group" aria-label=${tr("Ready-made settings")}>${buttons}${left}</p>`}
<div class="carts-panel">
${cartCards(baked)}
${otherCards(baked)}
${effectCard(baked)}
</div>
<div class="carts-warnings" hidden></div>
<details class="carts-more carts-take"><summary>${tr("Take it along")}</summary></details>
${back > 0 && html`<p class="carts-reset-row"><button type="button" class="carts-button carts-undo" disabled>${tr("Undo")}</button> <button type="button" class="carts-button carts-reset" disabled>${tr("Reset all values")}</button></p>`}
</div>`;
}

/** @param {Baked} baked */
function cartCards(baked) {
  const { fence, run } = baked;
  return run.header.bodies.map(({ name }, i) => {
    const style = `carts-${styleOf(i)}`;
    const title = isWord(name) ? name : tr("Cart {name}", { name });
    const own = fence.controls.filter(({ set }) => ownerOf(set) === name);
    return html`<div class="carts-card ${style}" role="group" aria-label=${title} data-body=${name}>
<p class="carts-heading"><svg class="carts-swatch" viewBox="0 0 26 12" width="26" height="12" aria-hidden="true"><path class="carts-curve ${style}" d="M0 6H26"/><path class="carts-dot ${style}" d=${MARKERS[styleOf(i)]} transform="translate(13 6)"/></svg>${title}</p>
${own.map((one) => control(one, fence.id))}
<dl class="carts-readouts">${readouts(baked)}</dl></div>
`;
  });
}

/** @param {Baked} baked */
function readouts({ fence, view }) {
  const { camera, forces } = fence;
  const speed = speedUnit(view.velocity)[1];
  const rows = [
    [tr("mass"), "m", "mass", "kg"],
    [camera ? tr("position seen from the camera") : tr("position"), "x", "x", "m"],
    [camera ? tr("velocity seen from the camera") : tr("velocity"), "v", "v", speed],
  ];
  if (forces === "shown") {
    rows.push([tr("resultant force"), "R", "F", "N"], [tr("acceleration"), "a", "a", "m/s²"]);
  }
  return rows.map(
    ([name, symbol, quantity, unit]) =>
      html`<div><dt><span class="carts-word">${name} </span><i>${symbol}</i></dt><dd><span class="carts-value" data-quantity=${quantity}></span> ${unit}</dd></div>`,
  );
}

/** Sliders of the contact, and those of nothing that has a card of its own. @param {Baked} baked */
function otherCards({ fence, run: { header } }) {
  const owners = header.bodies.map(({ name }) => name);
  const contact = fence.controls.filter(({ set }) => ownerOf(set) === "contact");
  const rest = fence.controls.filter(
    ({ set }) =>
      ![...owners, "contact", "effects"].includes(ownerOf(set)) && !effectOf(set, header),
  );
  const cards = /** @type {[string, Control[]][]} */ ([
    [tr("Contact"), contact],
    [tr("Scene"), rest],
  ]);
  return cards
    .filter(([, own]) => own.length)
    .map(
      ([title, own]) => html`<div class="carts-card" role="group" aria-label=${title}>
<p class="carts-heading">${title}</p>
${own.map((one) => control(one, fence.id))}</div>
`,
    );
}

/** Switches and sliders of what acts, where the lesson offers any. @param {Baked} baked */
function effectCard({ fence, run: { header } }) {
  const own = fence.controls.filter(({ set }) => effectOf(set, header));
  if (!own.length && !fence.switches.length) return null;
  const title = tr("What acts");
  const boxes = fence.switches.map(
    ({ set, label, value }) =>
      html`<div class="carts-switch"><label><input type="checkbox" data-switch=${set} autocomplete="off"${value && html` checked`} disabled> <span>${label}</span></label><p class="carts-error" hidden></p></div>`,
  );
  return html`<div class="carts-card carts-effect-card" role="group" aria-label=${title}>
<p class="carts-heading">${title}</p>
${boxes}
${own.map((one) => control(one, fence.id))}</div>`;
}

/** @param {Control} control @param {string} id of the scene */
function control({ set, label, short, unit, low, high, step, value }, id) {
  const decimals = Math.max(...[step, low, value].map((one) => decimalsOf(one)));
  const text = fixed(value, decimals).replace("−", "-");
  const box = `${id}-${set.replaceAll(".", "-")}`;
  const slider = tr("{label}, slider", { label });
  const measured = unit ? tr(" in {unit}", { unit }) : "";
  return html`<div class="carts-control" data-set=${set}>
<label for=${box}>${short}</label>
<input type="range" class="carts-slider" min=${low} max=${high} step=${step} value=${value} aria-label=${slider} aria-valuetext="${text} ${unit}" disabled>
<span class="carts-typed"><input type="text" class="carts-number-box" id=${box} inputmode="decimal" autocomplete="off" spellcheck="false" value=${text} aria-label="${label}${measured}" disabled> <span class="carts-unit-text">${unit}</span></span>
<p class="carts-error" hidden></p>
</div>
`;
}

/** @param {string} set the target of a slider @returns {string} */
const ownerOf = (set) => set.split(".")[0] ?? "";
