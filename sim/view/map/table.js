/** The table behind a map: a part of the values, evenly spread, for readers who want numbers. */

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
 * Heads of the columns and lines, each with its head first.
 * @param {number} columns @param {number} rows 1: a curve
 * @param {(axis: number, place: number) => string} axisText @param {(place: number) => string} valueText
 * @returns {{head: string[], lines: string[][]}}
 */
export function tableOf(columns, rows, axisText, valueText) {
  if (rows === 1) {
    const lines = spread(columns, 2 * ROWS - 1).map((k) => [axisText(0, k), valueText(k)]);
    return { head: [], lines };
  }
  const across = spread(columns, COLUMNS);
  const lines = spread(rows, ROWS).map((row) => [
    axisText(1, row),
    ...across.map((k) => valueText(row * columns + k)),
  ]);
  return { head: across.map((k) => axisText(0, k)), lines };
}
