/**
 * Answers as a table for a spreadsheet. A cell that a spreadsheet could take for a formula begins with
 * an apostrophe; numbers stay numbers. The same as sim/lesson/csv_text.py. Pure.
 */

const COLUMNS = [
  "lesson",
  "form",
  "student",
  "id",
  "type",
  "asked",
  "value",
  "unit",
  "said",
  "sure",
  "tries",
  "first",
  "last",
  "hash",
];
// A formula may begin with these, also as wide letters, and behind marks that nobody sees. A text that
// begins with a space, a tab or a new line is suspect too. A % alone is a unit.
const RISKY = /^\s|^(?!%$)[\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff"']*[=+\-@|%＝＋－＠]/u;

/** @param {any} value @returns {string} one cell, quoted */
export function csvCell(value) {
  if (typeof value === "number" && Number.isFinite(value)) return String(value);
  const text =
    typeof value === "string"
      ? value
      : value === null || value === undefined
        ? ""
        : JSON.stringify(value);
  const clean = text.replaceAll("\u0000", "");
  return `"${(RISKY.test(clean) ? `'${clean}` : clean).replaceAll('"', '""')}"`;
}

/** @param {any} content of an answer file @returns {string} */
export function csvText(content) {
  const rows = content.items.map((/** @type {any} */ item) =>
    COLUMNS.map((name) =>
      csvCell(
        name in item
          ? item[name]
          : ["lesson", "form", "student"].includes(name)
            ? content[name]
            : "",
      ),
    ).join(","),
  );
  return `\uFEFF${[COLUMNS.join(","), ...rows].join("\r\n")}\r\n`;
}
