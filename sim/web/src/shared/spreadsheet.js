/**
 * A table as the reader's spreadsheet opens it: where numbers are written with a comma (0,5), a comma between
 * cells and a point in numbers make dates and texts of them; there cells are parted by semicolons. What the
 * browser speaks tells which, not the page: a class reads English pages with a German spreadsheet. Our own
 * readers take both.
 */

const CELL = /("(?:[^"]|"")*"|[^,\r\n"]*)(,|\r?\n|$)/g;
const NUMBER = /^-?\d+(?:\.\d+)?(?:e[+-]?\d+)?$/i;

/** @param {string} csv cells between commas, numbers with a point @param {string} language of the browser @returns {string} */
export function forSpreadsheet(csv, language = navigator.language) {
  if (!hasComma(language)) return csv;
  return csv.replace(CELL, (_, cell, end) => written(cell) + (end === "," ? ";" : end));
}

/** @param {string} cell */
function written(cell) {
  if (NUMBER.test(cell)) return cell.replace(".", ",");
  return cell.includes(";") && !cell.startsWith('"') ? `"${cell}"` : cell;
}

/** @param {string} language */
function hasComma(language) {
  try {
    return new Intl.NumberFormat(language).format(0.5).includes(",");
  } catch {
    return false; // no language that this browser knows
  }
}
