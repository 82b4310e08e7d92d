/** What a fit says: numbers with their intervals, what is not told and why, sentences. */

import { html } from "../shared/dom.js";

/** @typedef {import("./types.js").Report} Report */

/** @param {HTMLElement} place @param {Report} report */
export function showResult(place, report) {
  place.hidden = false;
  const parts = [html("p", "carts-heading", "What the readings say")];
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
 * @param {Element} place @param {import("./types.js").Read} read @param {number[][] | null} residuals in m
 */
export function showTable(place, read, residuals) {
  const [letter, unit] = read.kind === "length" ? ["x", "m"] : ["F", "N"];
  const heads = ["t in s", ...read.names.map((name) => `${letter} of ${name} in ${unit}`)];
  if (residuals) heads.push(...read.names.map((name) => `residual of ${name} in mm`));
  const head = html("tr");
  for (const text of heads) {
    const cell = html("th", "", text);
    cell.setAttribute("scope", "col");
    head.append(cell);
  }
  /** @type {Map<number, string[]>} */
  const rows = new Map();
  for (const [k, track] of read.tracks.entries()) {
    for (const [n, t] of track.t.entries()) {
      const row = rows.get(t) ?? Array.from({ length: heads.length - 1 }, () => "");
      row[k] = minus(Number(track.value[n]).toFixed(4));
      if (residuals) row[2 + k] = minus((1000 * Number(residuals[k]?.[n])).toFixed(2));
      rows.set(t, row);
    }
  }
  const body = [...rows]
    .sort(([a], [b]) => a - b)
    .map(([t, cells]) => {
      const row = html("tr");
      row.append(...[minus(t.toFixed(4)), ...cells].map((cell) => html("td", "", cell)));
      return row;
    });
  place.querySelector("thead")?.replaceChildren(head);
  place.querySelector("tbody")?.replaceChildren(...body);
  place.closest("details")?.querySelector(".carts-measured-rest")?.remove();
}

/** @param {string} text */
const minus = (text) => text.replace("-", "−");
