/** Hands a file to the reader: the browser saves it where downloads go. */

import { forSpreadsheet } from "./spreadsheet.js";

const FORGOTTEN_AFTER = 60_000; // ms; a slow disk may ask before it begins

/** @param {string} name @param {string} text @param {string} type a table (text/csv) is saved as spreadsheets here read it */
export function download(name, text, type) {
  const saved = type === "text/csv" ? forSpreadsheet(text) : text;
  downloadBlob(name, new Blob([saved], { type }));
}

/** @param {string} name @param {Blob} blob */
export function downloadBlob(name, blob) {
  const link = document.createElement("a");
  const address = URL.createObjectURL(blob);
  link.href = address;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), FORGOTTEN_AFTER);
}
