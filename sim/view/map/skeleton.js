/**
 * A map as it stands in the page: figure, the point with its sliders, further sliders, table. Without a script
 * figure and table are all there is. The picture holds the bands; the script lays a canvas with the same over it.
 */

import { tr } from "../language.js";
import { html } from "../markup.js";
import { decimalsOf, fixed } from "../numbers.js";
import { liveMark } from "../skeleton/mark.js";
import { BOTTOM, curve, heightOf, LEFT, RIGHT, TOP, under, WIDTH } from "./figure.js";
import { tableOf } from "./table.js";
import { axisDecimals, named, shown, valueText } from "./words.js";

/** @typedef {import("./types.js").MapFacts} MapFacts */
/** @typedef {import("./types.js").Drawn} Drawn */

/** @param {MapFacts} facts @param {Drawn} draw @param {string} picture address; empty for a curve @returns {import("../markup.js").Markup} the inside of `<carts-map>` */
export function inside(facts, draw, picture) {
  const { id, title, why } = draw;
  return html`<div class="carts-map-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
<div class="carts-map-body">
<div class="carts-map-figure" role="group" aria-label=${named(facts)}>
${under(facts, picture)}
${over(facts, draw)}
</div>
${side(facts, draw)}
</div>
${table(facts, draw)}
<details class="carts-more carts-map-model"><summary>${tr("How this was computed")}</summary><p class="carts-map-why">${why}</p></details>
<noscript><p class="carts-noscript">${tr("The picture and the table show the values. Asking single points needs JavaScript.")}</p></noscript>
</div>`;
}

/** @param {Drawn} draw @param {number} place */
const valueAt = ({ values }, place) => values[place] ?? Number.NaN;

/** @param {MapFacts} facts @param {number} axis @param {number} place */
function axisText(facts, axis, place) {
  const along = facts.axes[axis];
  return along ? fixed(shown(Number(along.values[place]), along), axisDecimals(along)) : "";
}

/** Edge, curve and the cross that marks a point. @param {MapFacts} facts @param {Drawn} draw */
function over(facts, draw) {
  const height = heightOf(facts);
  const all = draw.values.map((value) => value ?? Number.NaN);
  const line = facts.axes.length === 1 ? curve(facts, facts.axes[0]?.values ?? [], all) : "";
  return html`<svg class="carts-map-over" viewBox="0 0 ${WIDTH} ${height}" width=${WIDTH} height=${height} aria-hidden="true" focusable="false">
<rect class="carts-map-edge" x=${LEFT} y=${TOP} width=${RIGHT - LEFT} height=${BOTTOM - TOP}/>
<path data-part="curve" class="carts-curve" d=${line}/>
<g data-part="cross"><path data-part="lines" class="carts-map-cross" d=""/><circle data-part="point" class="carts-map-point" r="6" cx="0" cy="0" visibility="hidden"/></g>
</svg>`;
}

/** @param {MapFacts} facts @param {Drawn} draw */
function side(facts, { id }) {
  const { label, unit, axes, here, of, controls } = facts;
  const points = axes.map(({ set, label: name, unit: measured, values }, k) => {
    const place = here[k] ?? 0;
    const text = axisText(facts, k, place);
    const range = html`min="0" max=${values.length - 1} step="1" value=${place}`;
    return slider({ id, set, label: name, unit: measured, range, text }, " carts-map-axis");
  });
  const further = controls.map(({ set, label: name, unit: measured, low, high, step, value }) => {
    const decimals = Math.max(...[step, low, value].map((one) => decimalsOf(one)));
    const range = html`min=${low} max=${high} step=${step} value=${value}`;
    return slider(
      { id, set, label: name, unit: measured, range, text: fixed(value, decimals) },
      "",
    );
  });
  const ids = axes.map(({ set }) => `${id}-${set.replaceAll(".", "-")} `).join("");
  const at = valueText(facts.at ?? Number.NaN, facts);
  return html`<div class="carts-map-side">
<p class="carts-map-start"><button type="button" class="carts-button carts-map-open" hidden>${tr("Open the map")}</button> <span class="carts-map-wait" hidden>${tr("The map is a picture until you open it. Then every point can be asked for its value.")}</span></p>
<p class="carts-heading">${tr("One point of the map")}</p>
${points}<p class="carts-map-value"><span>${label}</span> <output class="carts-map-number" for=${ids}>${facts.at === null ? at : `${at} ${unit}`}</output></p>
<progress class="carts-map-progress" max="1" value="1" aria-label=${tr("points computed")}></progress>
${of && html`<p class="carts-map-start"><button type="button" class="carts-button carts-map-run" disabled>${tr("Run this point")}</button> <a href="#${of}">${tr("the scene")}</a></p>`}
${controls.length > 0 && html`<p class="carts-heading">${tr("All points of the map")}</p>`}
${further}</div>`;
}

/** @param {{id: string, set: string, label: string, unit: string, range: import("../markup.js").Markup, text: string}} of @param {string} more class */
function slider({ id, set, label, unit, range, text }, more) {
  const box = `${id}-${set.replaceAll(".", "-")}`;
  const spoken = tr("{label}, slider", { label });
  return html`<div class="carts-control${more}" data-set=${set}>
<label for=${box}>${label}</label>
<input type="range" class="carts-slider" ${range} aria-label=${spoken} aria-valuetext=${`${text} ${unit}`.trim()} disabled>
<span class="carts-typed"><input type="text" class="carts-number-box" id=${box} inputmode="decimal" autocomplete="off" spellcheck="false" value=${text.replace("−", "-")} aria-label=${named({ label, unit })} disabled> <span class="carts-unit-text">${unit}</span></span>
<p class="carts-error" hidden></p>
</div>
`;
}

/** @param {MapFacts} facts @param {Drawn} draw */
function table(facts, draw) {
  const [first, second] = facts.axes;
  const columns = first?.values.length ?? 0;
  const { head, lines } = tableOf(
    columns,
    second?.values.length ?? 1,
    (axis, place) => axisText(facts, axis, place),
    (place) => valueText(valueAt(draw, place), facts),
  );
  const heads = second ? head : [facts.label];
  const across = html`<tr><td></td><th scope="colgroup" colspan=${heads.length}>${first && named(first)}</th></tr>`;
  const rows = lines.map(
    ([name, ...cells]) =>
      html`<tr><th scope="row">${name}</th>${cells.map((cell) => html`<td>${cell}</td>`)}</tr>`,
  );
  const summary = tr("Table: {quantity}", { quantity: named(facts) });
  return html`<details class="carts-more carts-map-table"><summary>${summary}</summary>
<div class="carts-scroll"><table class="carts-table"><thead>
${second && across}
<tr><th scope="col">${named(second ?? first ?? facts)}</th>${heads.map((cell) => html`<th scope="col">${cell}</th>`)}</tr></thead>
<tbody>${rows}</tbody></table></div></details>`;
}
