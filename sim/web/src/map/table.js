/** Fills the table behind a map. */

import { tableOf } from "../../../view/map/table.js";
import { valueText } from "../../../view/map/words.js";
import { html } from "../shared/dom.js";

/**
 * @param {HTMLElement} table @param {import("../../../view/map/types.js").Grid} grid
 * @param {(axis: number, place: number) => string} axisText @param {import("../../../view/map/types.js").MapFacts} facts
 */
export function fillTable(table, grid, axisText, facts) {
  const { head, lines } = tableOf(grid.columns, grid.rows, axisText, (place) =>
    valueText(Number(grid.values[place]), facts),
  );
  const heads = [...table.querySelectorAll("thead tr:last-child th:not(:first-child)")];
  for (const [k, text] of head.entries()) if (heads[k]) heads[k].textContent = text;
  const body = lines.map(([name = "", ...cells]) => {
    const line = html("tr");
    const first = html("th", "", name);
    first.setAttribute("scope", "row");
    line.append(first, ...cells.map((cell) => html("td", "", cell)));
    return line;
  });
  table.querySelector("tbody")?.replaceChildren(...body);
}
