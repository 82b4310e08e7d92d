/** Views beside the picture, empty: forces on each cart, the lens, momentum bars. */

import { linkedPairs } from "../effects.js";
import { outside } from "../effects-forces.js";
import { verticalNote } from "../forces.js";
import { tr } from "../language.js";
import { styleOf } from "../markers.js";
import { html } from "../markup.js";
import { speedUnit } from "../numbers.js";

/** @typedef {import("../types.js").Baked} Baked */
/** @typedef {import("../types.js").Header} Header */

/** The lens by itself: where there is room it stands between the picture and the sliders, for both
 * are looked at together. @param {Baked} baked */
export function near(baked) {
  return showsForces(baked) && frame(baked, "carts-views carts-near", lens(baked));
}

/** @param {Baked} baked */
export function views(baked) {
  const forces = showsForces(baked) && freeBody(baked);
  return frame(
    baked,
    "carts-views",
    html`${forces}
${bars(baked)}`,
  );
}

/** Whether there are forces of a contact, and the lesson shows them. @param {Baked} baked */
function showsForces({ fence, run }) {
  const linked = linkedPairs(run.header);
  const touches = run.header.contacts.some(({ stiffness, pair }) => stiffness || linked.has(pair));
  return fence.forces === "shown" && touches;
}

/** @param {Baked} baked @param {string} kinds @param {import("../markup.js").Markup} inside */
function frame({ fence }, kinds, inside) {
  return html`<div class=${kinds}${fence.predict && html` hidden`}>
${inside}
</div>`;
}

/** @param {Baked} baked @param {string} view */
const closed = ({ fence }, view) => !fence.opened.includes(view) && html` hidden`;

/** @param {Baked} baked */
function freeBody(baked) {
  const { bodies } = baked.run.header;
  const rows = [
    [tr("resultant force"), "R", "N", "F"],
    [tr("mass"), "m", "kg", "mass"],
    [tr("acceleration"), "a = R/m", "m/s²", "a"],
    [tr("change of velocity"), "Δv", speedUnit(baked.view.velocity)[1], "dv"],
  ];
  const alone = bodies.map(
    ({ name }, i) =>
      html`<div class="carts-alone carts-${styleOf(i)}" data-body=${name}><svg viewBox="0 0 260 60" width="260" height="60" aria-hidden="true"><rect class="carts-box" x="20" y="8" width="220" height="44" rx="4"/><text class="carts-name" x="130" y="24">${name}</text><g data-part="forces"></g></svg><ul></ul></div>
`,
  );
  const lines = rows.map(
    ([name, symbol, unit, quantity]) =>
      html`<tr><th scope="row">${name} <i>${symbol}</i>${quantity === "dv" && html` <span class="carts-touch-note"></span>`}, ${unit}</th>${bodies.map((body) => html`<td data-body=${body.name} data-quantity=${quantity}>–</td>`)}</tr>
`,
  );
  return html`<section class="carts-view carts-free-body" data-view="free-body"${closed(baked, "free-body")}>
<p class="carts-view-title"><span class="carts-heading">${tr("Forces on each cart")}</span> <label><input type="checkbox" class="carts-vertical"> ${tr("weight and support")}</label></p>
<div class="carts-bodies">
${alone}</div>
<p class="carts-vertical-note">${verticalNote(baked.run.header)}</p>
<div class="carts-scroll"><table class="carts-table carts-pairs"><thead><tr><th scope="col"><span class="carts-hidden">${tr("quantity")}</span></th>${bodies.map(({ name }) => html`<th scope="col">${name}</th>`)}</tr></thead><tbody>
${lines}</tbody></table></div>
<p class="carts-quiet">${tr("The two forces of a contact have the same size at every instant. How much a velocity changes depends on the mass too.")}</p>
</section>`;
}

/** @param {Baked} baked */
function lens(baked) {
  const sides = [0, 1].map(
    (k) =>
      html`<g data-side=${k}><rect data-part="body" class="carts-box" y="22" width="720" height="66"/><path data-part="spring" class="carts-spring"/><rect data-part="face" class="carts-face" x="-3" y="34" width="6" height="61" rx="2"/><text data-part="name" class="carts-name" y="42"></text><path data-part="arrow" class="carts-block-arrow"/></g>`,
  );
  return html`<section class="carts-view carts-lens" data-view="lens"${closed(baked, "lens")}>
<p class="carts-view-title"><span class="carts-heading">${tr("Lens on the contact, ×{times}", { times: 10 })}</span> <span class="carts-lens-note"></span></p>
<svg viewBox="0 0 360 110" width="360" height="110" aria-hidden="true"><path class="carts-rule" d="M0 96H360"/><path data-part="between" class="carts-coil"/>${sides}<path data-part="was" class="carts-was"/><path data-part="bar" class="carts-rule"/><text data-part="bar-text" y="17"></text><text data-part="when" x="8" y="108"></text></svg>
</section>`;
}

/** @param {Baked} baked */
function bars(baked) {
  const rows = momenta(baked.run.header).map(
    ([label, style]) =>
      html`<tr class="carts-${style}"><th scope="row">${label}</th><td data-when="before">–</td><td class="carts-bars" aria-hidden="true"><svg viewBox="0 0 128 20" width="128" height="20"><path class="carts-zero" d="M64 0V20"/><rect data-part="before"/><rect data-part="now"/></svg></td><td data-when="now">–</td><td data-when="change">–</td></tr>
`,
  );
  return html`<section class="carts-view" data-view="bars"${closed(baked, "bars")}>
<p class="carts-heading">${tr("Momentum before and now")}</p>
<div class="carts-scroll"><table class="carts-table"><thead><tr><th scope="col"><i>p</i>${tr(" in {unit}", { unit: "kg m/s" })}</th><th scope="col">${tr("before,")} <span class="carts-touch-note"></span></th><th scope="col" aria-hidden="true"></th><th scope="col">${tr("now")}</th><th scope="col">${tr("change")}</th></tr></thead><tbody>
${rows}</tbody></table></div>
<p class="carts-quiet">${tr("Hollow: before. Filled: now. + is to the right.")}</p>
</section>`;
}

/** Whose momentum the bars show, and in which style. @param {Header} header @returns {[string, string][]} */
function momenta(header) {
  const around = outside(header);
  /** @type {[string, string][]} */
  const rows = header.bodies.map(({ name }, i) => [name, styleOf(i)]);
  if (around) rows.push([around, "wall"]);
  if (rows.length > 1) rows.push([around ? tr("all together") : tr("all carts"), "total"]);
  return rows;
}
