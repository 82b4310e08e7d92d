/** What accuracy costs, as it stands in the page: one scene run twice, every method's error against its time. */

import { tr } from "../language.js";
import { html } from "../markup.js";
import { px } from "../numbers.js";
import { liveMark } from "../skeleton/mark.js";
import { breaksPart } from "./breaks.js";
import {
  BOTTOM,
  digitText,
  grid,
  HEIGHT,
  LEFT,
  levelAt,
  lineOf,
  RIGHT,
  TOP,
  WIDTH,
  yAt,
} from "./figure.js";
import { guess } from "./guess.js";
import { METHODS, stepping } from "./methods.js";
import { cells, FIRST, told, toleranceText } from "./words.js";

/** @typedef {import("../markup.js").Markup} Markup */
/** @typedef {import("./figure.js").CostRow} CostRow */
/**
 * @typedef {{id: string, title: string, names: Record<string, string>, measured: string, rows: CostRow[],
 *   breaks?: import("./breaks.js").Breaks, floor?: number, digits?: Record<string, number>,
 *   run: {header: import("./words.js").CostHeader, numbers: number[]}}} Values
 */

const PARTS = [19, 61, 103, 211, 499, 997, 9973];
const TOLERANCES = [1e-6, 1e-9, 1e-12];

/** @param {Values} values @returns {Markup} the inside of `<carts-cost>` */
export function inside({ id, title, names, measured, rows, floor, digits = {}, run, breaks }) {
  const told3 = told(run.header).map(
    ([head, got, real]) =>
      html`<tr><th scope="row">${head}</th><td>${got}</td><td>${real}</td></tr>`,
  );
  const said = measured && tr("Measured {when}.", { when: measured });
  return html`<div class="carts-cost-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
${choice(names)}
<div class="carts-cost-world"><svg class="carts-cost-stage" viewBox="0 0 640 118" width="640" height="118" role="img" aria-label=${tr("the carts as stepped, and exactly as dashed outlines")}></svg></div>
<div class="carts-transport carts-cost-transport"><button type="button" class="carts-button carts-play carts-cost-play" disabled>${tr("Play")}</button><input type="range" class="carts-cost-scrub" min="0" max="1" step="any" value="0" aria-label=${tr("time")} disabled><span class="carts-cost-clock">0.00 s</span></div>
<p class="carts-cost-legend"><span class="carts-cost-solid"></span> ${tr("as stepped")} <span class="carts-cost-dashed"></span> ${tr("exactly")}</p>
<div class="carts-cost-body">
<div><p class="carts-heading">${tr("Energy of motion")}</p><svg class="carts-cost-energy" viewBox="0 0 400 190" width="400" height="190" role="img" aria-label=${tr("energy of motion against time, as stepped and exactly")}></svg></div>
<div class="carts-scroll"><table class="carts-table carts-cost-told"><thead><tr><td></td><th scope="col">${tr("as stepped")}</th><th scope="col">${tr("exactly")}</th></tr></thead><tbody>${told3}</tbody></table></div>
</div>
<div class="carts-cost-measure">
<p class="carts-heading">${tr("Error against time")}</p>
<p class="carts-cost-start"><button type="button" class="carts-button carts-cost-go" disabled>${tr("Measure on this computer")}</button> <button type="button" class="carts-button carts-cost-stop" hidden>${tr("Stop")}</button> <progress class="carts-cost-progress" max="1" value="0" aria-label=${tr("methods measured")} hidden></progress> <span class="carts-cost-say" role="status">${said}</span></p>
${guess()}
<div class="carts-cost-known">
${figure(rows, floor, digits)}
${table(rows, run.header.until)}
</div>
</div>
${breaks && breaksPart(breaks)}
<noscript><p class="carts-noscript">${tr("The figure and the tables show what was measured. Trying and measuring here needs JavaScript.")}</p></noscript>
</div>`;
}

/** @param {number} n @returns {string} a step, as a part of the run */
const partText = (n) => tr("run / {n}", { n });

/** Scene, method and step. @param {Record<string, string>} names of the scenes */
function choice(names) {
  const scenes = Object.entries(names).map(
    ([name, text]) => html`<option value=${name}>${text}</option>`,
  );
  const methods = stepping().map(
    (name) =>
      html`<option value=${name}${name === FIRST.method && html` selected`}>${METHODS[name]?.label}</option>`,
  );
  const parts = PARTS.map(
    (n) => html`<option value=${n}${n === FIRST.parts && html` selected`}>${partText(n)}</option>`,
  );
  const tolerances = TOLERANCES.map(
    (rtol) => html`<option value=${rtol}>${toleranceText(rtol)}</option>`,
  );
  return html`<div class="carts-cost-choice">
<label>${tr("scene")} <select autocomplete="off" class="carts-cost-scene" disabled>${scenes}</select></label>
<label>${tr("method")} <select autocomplete="off" class="carts-cost-method" disabled>${methods}</select></label>
<label>${tr("step")} <select autocomplete="off" class="carts-cost-step" disabled>${parts}</select><select autocomplete="off" class="carts-cost-rtol" aria-label=${tr("tolerance")} disabled hidden>${tolerances}</select></label>
</div>`;
}

/** @param {CostRow[]} rows @param {number | undefined} floor m/s @param {Record<string, number>} digits */
function figure(rows, floor, digits) {
  const { x, y } = grid();
  const methods = Object.entries(METHODS);
  const series = methods.map(([name, { mark }]) => {
    const { line, points } = lineOf(rows, name, floor);
    const marks = points.map(
      ([across, down]) =>
        html`<path class="carts-cost-point" transform="translate(${across} ${down})" d=${mark}/>`,
    );
    return html`<g class="carts-cost-of-${name}" data-method=${name}><path class="carts-cost-line" d=${line}/>${marks}</g>`;
  });
  const key = methods.map(
    ([name, { mark, label }]) =>
      html`<li class="carts-cost-of-${name}"><svg viewBox="-8 -8 16 16" width="16" height="16" aria-hidden="true"><path class="carts-cost-point" d=${mark}/></svg> ${label} <span class="carts-cost-digit carts-quiet" data-of=${name}>${digitText(digits[name])}</span></li>`,
  );
  return html`<svg class="carts-cost-figure" viewBox="0 0 ${WIDTH} ${HEIGHT}" width=${WIDTH} height=${HEIGHT} role="img" aria-label=${tr("largest error of a velocity against time, one line per method; the numbers are in the table below")}>
${x.map(([at, text]) => html`<path class="carts-grid" d="M${at} ${TOP}V${BOTTOM}"/><text class="carts-tick-x" x=${at} y=${BOTTOM + 16}>${text}</text>`)}
${y.map(([at, text]) => html`<path class="carts-grid" d="M${LEFT} ${at}H${RIGHT}"/><text class="carts-tick-y" x=${LEFT - 7} y=${Number(at) + 4}>${text}</text>`)}
<text class="carts-unit" x=${RIGHT} y=${BOTTOM + 36} text-anchor="end">${tr("time, as a multiple of the exact outcome’s")}</text>
<text class="carts-unit" transform="translate(14 ${(TOP + BOTTOM) / 2}) rotate(-90)" text-anchor="middle">${tr("largest error of a velocity in m/s")}</text>
<path class="carts-cost-floor" d=${levelAt(floor)}/><text class="carts-cost-floor-name carts-quiet" x=${RIGHT - 4} y=${px(yAt(floor || 1e-16) - 5)} text-anchor="end">${floor && tr("rounding of a double")}</text><path class="carts-cost-asked"/>
<g class="carts-cost-series">${series}</g>
<circle class="carts-cost-ring" r="9" visibility="hidden"/>
</svg>
<ul class="carts-cost-key">${key}</ul>`;
}

/** @param {CostRow[]} rows @param {number} until in s */
function table(rows, until) {
  const lines = rows.map((row) => {
    const [head, ...values] = cells(row, until);
    return html`<tr><th scope="row">${head}</th>${values.map((value) => html`<td>${value}</td>`)}</tr>`;
  });
  const heads = [
    tr("method"),
    tr("step"),
    tr("forces computed"),
    tr("time"),
    tr("error of v in m/s"),
    tr("error of energy, of the larger of start and end"),
  ];
  return html`<details class="carts-more carts-cost-table"><summary>${tr("Table of all measurements")}</summary><div class="carts-scroll"><table class="carts-table"><thead><tr>${heads.map((head) => html`<th scope="col">${head}</th>`)}</tr></thead><tbody>${lines}</tbody></table></div></details>`;
}
