/** The lesson's text as the build shipped it, see sim/pages/teach/publish.py. */

import { gunzip } from "../runtime/payload.js";
import { bring } from "../shared/bring.js";

/** What stands in the place of a note or a marking guide, as in sim/pages/teach/withheld.py; a test holds the two together. */
export const KEPT_OUT = "(stands in the teacher's own file)";

/**
 * @typedef {object} Told
 * @property {string} file path of the lesson in its site
 * @property {string | null} text null: it is not shipped, the teacher opens the file
 * @property {string} hash sha256 of the whole file
 * @property {Record<string, string>} files scene files that the lesson names
 * @property {object} lesson what Python needs to know beside the text
 */

/** @param {string} address of the script @returns {Promise<Told>} */
export async function loadLesson(address) {
  const packed = await bring("__cartsLesson", address);
  if (packed === null) throw new Error("the lesson's text is missing in this site");
  delete (/** @type {any} */ (globalThis).__cartsLesson);
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
  return JSON.parse(decoder.decode(await gunzip([bytes])));
}

/** @param {string} text @returns {Promise<string>} sha256; empty where the browser has none (plain http) */
export async function hashOf(text) {
  if (!globalThis.crypto?.subtle) return "";
  const bytes = new TextEncoder().encode(text);
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
