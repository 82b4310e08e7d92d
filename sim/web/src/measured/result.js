/** What a fit says: numbers with their intervals, what is not told and why, sentences. */

import { tableOf } from "../../../view/measured/table.js";
import { fixed } from "../../../view/numbers.js";
import { html } from "../shared/dom.js";

/** @typedef {import("../../../view/measured/types.js").Report} Report */

/** @param {HTMLElement} place @param {Report} report */
export function showResult(place, report) {
  place.hidden = false;
  const parts = [html("p", "carts-heading", "What the readings say")];
  if (report.segments?.length) parts.push(strip(report));
  if (report.known) {
    parts.push(html("p", "carts-measured-law-words", `Fitted with ${report.law_words}.`));
    parts.push(table(report));
    for (const { name, reason } of report.untold) {
      const row = html("p", "carts-measured-untold");
      row.append(html("strong", "", `Not printed: ${name}.`), ` ${upper(reason)}.`);
      parts.push(row);
    }
  }
  const said = html("ul", "carts-measured-sentences");
  said.append(...report.sentences.map((sentence) => html("li", "", sentence)));
  parts.push(said);
  place.replaceChildren(...parts);
}

/**
 * What each cart did, as a coloured strip over the time of the readings; the same in words for those who hear it.
 * @param {Report} report
 */
function strip(report) {
  const segments = report.segments ?? [];
  const begin = Math.min(...segments.map((one) => one.from));
  const length = Math.max(...segments.map((one) => one.until)) - begin;
  const made = html("div", "carts-measured-strip");
  for (const name of report.names) {
    const own = segments.filter((one) => one.cart === name);
    const words = own
      .map((one) => `${one.kind} ${fixed(one.from, 2)} to ${fixed(one.until, 2)} s`)
      .join(", ");
    const bar = html("div", "carts-measured-strip-bar");
    bar.setAttribute("role", "img");
    bar.setAttribute("aria-label", `${name}: ${words}`);
    for (const { from, until, kind } of own) {
      const part = html(
        "span",
        "",
        100 * (until - from) > 12 * length || kind === "contact" ? kind : "",
      );
      part.dataset.kind = kind;
      part.title = `${kind}, ${fixed(from, 2)} to ${fixed(until, 2)} s`;
      part.style.left = `${(100 * (from - begin)) / length}%`;
      part.style.width = `${(100 * (until - from)) / length}%`;
      bar.append(part);
    }
    made.append(html("span", "carts-measured-strip-name", name), bar);
  }
  return made;
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
