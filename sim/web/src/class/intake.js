/** From dropped files to what is in them: bytes go to Python in parcels, rows come back. */

import { tr } from "../../../view/language.js";

/** @typedef {import("./classroom.js").Found} Found */
/** @typedef {{name: string, base64: string}} Parcel */
/** @typedef {(message: Record<string, unknown>) => Promise<Record<string, any>>} Ask */

export const MOST_JSON = 30_000_000; // bytes of a file of any kind; Python knows the kind, and its limit
const MOST_ZIP = 60_000_000; // in a page; the command line takes more
const PARCEL_BYTES = 1_000_000;
const PARCEL_FILES = 25;

const MOST_TABLE = 10_000_000; // bytes; the command line takes more

/** Whether a file is a table of marks, by its name. @param {File} file */
export const isTable = ({ name }) => /\.(csv|tsv|xlsx?|ods)$/i.test(name);

/**
 * A table as Python is told of it; a text: why it is not.
 * @param {File} file @param {number} group on whose field it was dropped
 * @returns {Promise<import("./classroom.js").Table | string>}
 */
export async function asTable(file, group) {
  if (file.size > MOST_TABLE) return tr("this table is too large for a page");
  const base64 = await asBase64(file);
  if (base64 === null) return tr("this file cannot be read");
  return { name: file.name, base64, form: "", group };
}

/**
 * Reads files parcel by parcel; `found` is called after each.
 * @param {File[]} files @param {Ask} ask
 * @param {(found: Found, done: number) => void | Promise<void>} found
 */
export async function readAll(files, ask, found) {
  let done = 0;
  for (const parcel of parcels(files)) {
    const refused = /** @type {[string, string][]} */ ([]);
    const sent = /** @type {Parcel[]} */ ([]);
    for (const file of parcel) {
      const name = file.webkitRelativePath || file.name;
      const reason = tooLarge(file);
      const base64 = reason ? null : await asBase64(file);
      if (base64 === null) refused.push([name, reason || tr("this file cannot be read")]);
      else sent.push({ name, base64 });
    }
    done += parcel.length;
    if (refused.length) {
      await found({ records: [], keys: [], marks: [], refused, next: null }, done);
    }
    /** @type {number | null} */
    let from = sent.length ? 0 : null;
    let held = false; // by Python: the files of a parcel are sent once
    try {
      while (from !== null) {
        const files = held ? {} : { files: sent };
        const answer = /** @type {any} */ (
          await ask({ kind: "class", do: "read", from, ...files })
        );
        held = !answer.lost; // by a Python that came in the place of another
        if (!held) continue;
        from = answer.next;
        await found(answer, done);
      }
    } finally {
      if (from) void ask({ kind: "class", do: "read", files: [] }).catch(() => {}); // deleted: there too
    }
  }
}

/** @param {File[]} files @returns {Generator<File[]>} */
function* parcels(files) {
  /** @type {File[]} */
  let parcel = [];
  let bytes = 0;
  for (const file of files) {
    if (parcel.length && (bytes + file.size > PARCEL_BYTES || parcel.length >= PARCEL_FILES)) {
      yield parcel;
      [parcel, bytes] = [[], 0];
    }
    parcel.push(file);
    bytes += file.size;
  }
  if (parcel.length) yield parcel;
}

/** @param {File} file */
function tooLarge(file) {
  if (file.size <= MOST_JSON) return "";
  if (!file.name.toLowerCase().endsWith(".zip")) {
    return tr("this file is too large to be a file of answers");
  }
  return file.size > MOST_ZIP ? tr("this zip is too large for a page: use “carts class”") : "";
}

/** @param {File} file @returns {Promise<string | null>} null: a folder, or a file that is gone */
function asBase64(file) {
  return new Promise((resolve) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result).split(",")[1] ?? "");
    reader.onerror = () => resolve(null);
    reader.readAsDataURL(file);
  });
}
