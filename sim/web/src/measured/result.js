/** What a fit says: numbers with their intervals, what is not told and why, sentences. */

import { tableOf } from "../../../view/measured/table.js";
import { html } from "../shared/dom.js";

/** @typedef {import("../../../view/measured/types.js").Report} Report */

/** @param {HTMLElement} place @param {Report} report */
export function showResult(place, report) {
  place.hidden = false;
  const parts = [html("p", "carts-heading", "What the readings say")];
  if (report.known) {
    parts.push(html("p", "carts-measured-law-words", `Fitted with ${report.law_words}.`));
    if (report.added) parts.push(html("p", "", report.added));
    if (report.doubt) parts.push(html("p", "carts-measured-doubt", report.doubt));
    parts.push(table(report));
    parts.push(...notPrinted(report.untold));
  }
  const said = html("ul", "carts-measured-sentences");
  said.append(...report.sentences.map((sentence) => html("li", "", sentence)));
  parts.push(said);
  if (report.rungs) parts.push(ladder(report.rungs));
  place.replaceChildren(...parts);
}

/**
 * A line for each reason: what one cause hides is told together.
 * @param {Report["untold"]} untold
 */
function notPrinted(untold) {
  /** @type {Map<string, string[]>} */
  const names = new Map();
  for (const { name, reason } of untold) names.set(reason, [...(names.get(reason) ?? []), name]);
  return [...names].map(([reason, hidden]) => {
    const row = html("p", "carts-measured-untold");
    row.append(html("strong", "", `Not printed: ${hidden.join("; ")}.`), ` ${upper(reason)}.`);
    return row;
  });
}

/**
 * What brakes the carts, largest first, with what these readings can show as the line between.
 * @param {NonNullable<Report["rungs"]>} rungs
 */
function ladder({ line, taken, rows }) {
  const item = (/** @type {{sentence: string}} */ { sentence }) => html("li", "", sentence);
  const list = html("ol", "carts-ladder");
  list.append(
    ...rows.filter(({ verdict }) => verdict !== "not-shown").map(item),
    html("li", "carts-ladder-line", line),
    ...rows.filter(({ verdict }) => verdict === "not-shown").map(item),
  );
  const root = html("details", "carts-measured-ladder"); // a lesson may ask for it first
  root.append(
    html("summary", "", "What do these readings call for?"),
    html("p", "", "Each effect alone, largest first:"),
    list,
    html("p", "carts-quiet", taken),
  );
  return root;
}

/** @param {Report} report */
function table(report) {
  const made = html("table", "carts-table carts-measured-known");
  const head = html("tr");
  for (const text of ["what", "value ± half of the 95 % interval"]) {
    const cell = html("th", "", text);
    cell.setAttribute("scope", "col");
    head.append(cell);
  }
  const top = html("thead");
  top.append(head);
  const body = html("tbody");
  for (const { key, name, text } of report.known) {
    const row = html("tr");
    row.dataset.key = key;
    const title = html("th", "", name);
    title.setAttribute("scope", "row");
    row.append(title, html("td", "", text.replace(`${name}: `, "")));
    body.append(row);
  }
  made.append(top, body);
  const scroll = html("div", "carts-scroll");
  scroll.append(made);
  return scroll;
}

/** @param {string} text */
const upper = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/**
 * The table of all readings, residuals beside them if there are any.
 * @param {Element} place @param {import("../../../view/measured/types.js").Read} read @param {number[][] | null} residuals in m
 */
export function showTable(place, read, residuals) {
  const { head, rows } = tableOf(read, residuals);
  const top = html("tr");
  for (const text of head) {
    const cell = html("th", "", text);
    cell.setAttribute("scope", "col");
    top.append(cell);
  }
  const body = rows.map((cells) => {
    const row = html("tr");
    row.append(...cells.map((cell) => html("td", "", cell)));
    return row;
  });
  place.querySelector("thead")?.replaceChildren(top);
  place.querySelector("tbody")?.replaceChildren(...body);
  place.closest("details")?.querySelector(".carts-measured-rest")?.remove();
}
