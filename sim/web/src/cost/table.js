/** Fills a table of texts. */

import { html } from "../shared/dom.js";

/** @param {Element} table @param {string[][]} lines the first of each is its head */
export function fill(table, lines) {
  const body = lines.map(([head = "", ...values]) => {
    const line = html("tr");
    const first = html("th", "", head);
    first.setAttribute("scope", "row");
    line.append(first, ...values.map((value) => html("td", "", value)));
    return line;
  });
  table.querySelector("tbody")?.replaceChildren(...body);
}
