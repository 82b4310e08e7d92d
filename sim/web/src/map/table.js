/** The table behind a map: a part of the values, evenly spread. Twin of `table` in `pages/map/render.py`. */

import { html } from "../shared/dom.js";

/** @typedef {import("./types.js").Grid} Grid */

const COLUMNS = 6;
const ROWS = 11;

/** @param {number} count @param {number} most @returns {number[]} places, both ends among them */
export function spread(count, most) {
  const wanted = Math.min(most, count);
  return Array.from({ length: wanted }, (_, k) =>
    Math.floor((k * (count - 1)) / (wanted - 1) + 0.5),
  );
}

/**
 * @param {HTMLElement} table @param {Grid} grid
 * @param {(axis: number, place: number) => string} axisText @param {(value: number) => string} valueText
 */
export function fillTable(table, grid, axisText, valueText) {
  const flat = grid.axes.length === 1;
  const columns = flat ? [0] : spread(grid.columns, COLUMNS);
  const rows = flat ? spread(grid.columns, 2 * ROWS - 1) : spread(grid.rows, ROWS);
  if (!flat) {
    const head = [...table.querySelectorAll("thead tr:last-child th:not(:first-child)")];
    for (const [k, cell] of head.entries()) cell.textContent = axisText(0, Number(columns[k]));
  }
  const body = rows.map((row) => {
    const line = html("tr");
    const head = html("th", "", axisText(flat ? 0 : 1, row));
    head.setAttribute("scope", "row");
    const at = (/** @type {number} */ column) => (flat ? row : row * grid.columns + column);
    line.append(
      head,
      ...columns.map((column) => html("td", "", valueText(Number(grid.values[at(column)])))),
    );
    return line;
  });
  table.querySelector("tbody")?.replaceChildren(...body);
}
