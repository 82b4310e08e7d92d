/** What a fit says: numbers with their intervals, what is not told and why, sentences. */

import { ended, told, tr } from "../../../view/language.js";
import { tableOf } from "../../../view/measured/table.js";
import { semicolons } from "../../../view/measured/units.js";
import { html } from "../shared/dom.js";

/** @typedef {import("../../../view/measured/types.js").Report} Report */
/** @typedef {import("../../../view/language.js").Said} Said */

/** @param {HTMLElement} place @param {Report} report */
export function showResult(place, report) {
  place.hidden = false;
  const parts = [html("p", "carts-heading", tr("What the readings say"))];
  if (report.known) {
    const fitted = tr("Fitted with {law}.", { law: told(report.law_words) });
    parts.push(html("p", "carts-measured-law-words", fitted));
    if (report.added) parts.push(html("p", "", told(report.added)));
    if (report.doubt) parts.push(html("p", "carts-measured-doubt", told(report.doubt)));
    parts.push(table(report));
    parts.push(...notPrinted(report.untold));
  }
  const said = html("ul", "carts-measured-sentences");
  said.append(...report.sentences.map((sentence) => html("li", "", told(sentence))));
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
  for (const one of untold) {
    const reason = told(one.reason);
    names.set(reason, [...(names.get(reason) ?? []), told(one.name)]);
  }
  return [...names].map(([reason, hidden]) => {
    const row = html("p", "carts-measured-untold");
    const which = tr("Not printed: {names}.", { names: semicolons(hidden) });
    row.append(html("strong", "", which), ` ${ended(upper(reason))}`);
    return row;
  });
}

/**
 * What brakes the carts, largest first, with what these readings can show as the line between.
 * @param {NonNullable<Report["rungs"]>} rungs
 */
function ladder({ line, taken, rows }) {
  const item = (/** @type {{sentence: Said}} */ { sentence }) => html("li", "", told(sentence));
  const list = html("ol", "carts-ladder");
  list.append(
    ...rows.filter(({ verdict }) => verdict !== "not-shown").map(item),
    html("li", "carts-ladder-line", told(line)),
    ...rows.filter(({ verdict }) => verdict === "not-shown").map(item),
  );
  const root = html("details", "carts-measured-ladder"); // a lesson may ask for it first
  root.append(
    html("summary", "", tr("What do these readings call for?")),
    html("p", "", tr("Each effect alone, largest first:")),
    list,
    html("p", "carts-quiet", told(taken)),
  );
  return root;
}

/** @param {Report} report */
function table(report) {
  const made = html("table", "carts-table carts-measured-known");
  const head = html("tr");
  for (const text of [tr("what"), tr("value ± half of the 95 % interval")]) {
    const cell = html("th", "", text);
    cell.setAttribute("scope", "col");
    head.append(cell);
  }
  const top = html("thead");
  top.append(head);
  const body = html("tbody");
  for (const { key, name, interval } of report.known) {
    const row = html("tr");
    row.dataset.key = key;
    const title = html("th", "", told(name));
    title.setAttribute("scope", "row");
    row.append(title, html("td", "", told(interval)));
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
