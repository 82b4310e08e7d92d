/** The table of hard cases as it stands in the page: a row each, with what came out when it was made. */

import { tr } from "../language.js";
import { html } from "../markup.js";
import { short } from "../numbers.js";
import { liveMark } from "../skeleton/mark.js";
import { exactCell, expectedLines, METHODS, steppedCell } from "./words.js";

/** @typedef {import("./words.js").Wanted} Wanted */
/** @typedef {import("./words.js").Got} Got */
/**
 * @typedef {{name: string, sentence: string, why: string, wanted: Wanted, yaml: string, commands: string[],
 *   known: {exact: {got: Got}, stepped: {verdict: string, got: Got, step: number}[]}}} Row
 * @typedef {{id: string, title: string, groups: {name: string, rows: Row[]}[]}} Values
 */

const [MUST, EXACT] = [tr("must come out"), tr("exact")];
const COLUMNS = 3 + Object.keys(METHODS).length;

/** @param {Values} values @returns {import("../markup.js").Markup} the inside of `<carts-hard>` */
export function inside({ id, title, groups }) {
  const count = groups.reduce((sum, { rows }) => sum + rows.length, 0);
  const all = tr("Run all {n} here", { n: count });
  const methods = Object.values(METHODS).map((name) => html`<th scope="col">${name}</th>`);
  return html`<div class="carts-hard-frame" role="group" aria-labelledby="${id}-title">
<div class="carts-top"><p class="carts-title" id="${id}-title">${title}</p>${liveMark()}</div>
<div class="carts-note" role="status" hidden></div>
<p class="carts-hard-start"><button type="button" class="carts-button carts-hard-go" disabled>${all}</button> <button type="button" class="carts-button carts-hard-stop" hidden>${tr("Stop")}</button> <progress class="carts-hard-progress" max=${count} value="0" aria-label=${tr("cases run")} hidden></progress> <span class="carts-hard-say" role="status"></span></p>
<table class="carts-hard-table">
<thead><tr><th scope="col">${tr("case")}</th><th scope="col">${MUST}</th><th scope="col">${EXACT}</th>${methods}</tr></thead>
${groups.map(
  ({ name, rows }) => html`<tbody>
<tr class="carts-hard-group"><th scope="colgroup" colspan=${COLUMNS}>${name}</th></tr>
${rows.map(row)}</tbody>
`,
)}</table>
<noscript><p class="carts-noscript">${tr("The table shows what came out when this page was made. Running the cases here needs JavaScript.")}</p></noscript>
</div>`;
}

/** @param {Row} row */
function row({ name, sentence, why, wanted, known, yaml, commands }) {
  const lines = expectedLines(wanted).map((line, k) => html`${k > 0 && html`<br>`}${line}`);
  const heads = Object.values(METHODS);
  const cells = known.stepped.map((one, k) => {
    const [verdict, off] = steppedCell(wanted, one);
    return html`<td data-head=${heads[k]} data-part="stepped" data-verdict=${one.verdict}><b>${verdict}</b> <span>${off}</span></td>`;
  });
  const step = short(known.stepped[0]?.step ?? 0, 3);
  const steps = tr("The methods took steps of {step} s.", { step });
  const save = tr("Save this as {name}.yml, then:", { name });
  return html`<tr data-case=${name}><th scope="row"><b>${name}</b> ${sentence}</th>
<td data-head=${MUST}>${lines}</td><td data-head=${EXACT} data-part="exact">${exactCell(wanted, known.exact)}</td>${cells}</tr>
<tr class="carts-hard-more"><td colspan=${COLUMNS}><details class="carts-more"><summary>${tr("Why, and the scene")}</summary><p>${why} ${steps}</p><pre tabindex="0">${yaml}</pre><p>${save}</p>${commands.map((command) => html`<pre tabindex="0">${command}</pre>`)}</details></td></tr>
`;
}
