/** Where readings come from: files, pasted text, a typed table, or those that the lesson brings along. */

import { listed } from "../../../view/bodies.js";
import { told, tr } from "../../../view/language.js";
import { need, say } from "../shared/dom.js";
import { download } from "../shared/download.js";
import { decoded } from "./decoded.js";
import { Films, isFilm } from "./films.js";
import { Grid } from "./grid.js";

export const MOST_BYTES = 4_000_000; // of one file, as in sim/measured/sheet/cells.py; a test holds the two together
export const MOST_ZIPPED = 30_000_000; // of a zip, in which a film may be, as in sim/measured/zipped.py
const ZIP_NAME = /\.(zip|trz)$/i;
const FILE_NAME = /^\S+\.\w+$/;
const ZIP = 0x504b0304; // the first four bytes
const TYPED = "typed readings"; // as it is kept; shown in the reader’s language
const LINE = "line {line}"; // how Python names one: in_line of sim/measured/refusal.py

/** @typedef {import("./films.js").Take} Take */
/** @typedef {import("../../../view/measured/types.js").Refused} Refused */
/** @typedef {import("../../../view/language.js").Said} Said */

export class Source {
  /** @type {(now: undefined) => void} */
  #open = () => {};
  /** Until what was read here before is back: it would take the place of anything newer. */
  #opened = new Promise((resolve) => {
    this.#open = resolve;
  });

  /**
   * @param {HTMLElement} root @param {Take} take @param {() => void} changed something was typed
   * @param {(text: string) => void} tell
   * @param {(zip: string) => Promise<{text: string} | Refused>} unzip base64 to the readings in it @param {string} base address of the page's script
   */
  constructor(root, take, changed, tell, unzip, base) {
    this.root = root;
    this.unzip = unzip;
    const area = /** @type {HTMLElement} */ (root.closest("carts-measured") ?? root);
    this.films = new Films(area, base, take, tell);
    /** Other readings than those of a film. @type {Take} */
    this.take = (name, texts) => {
      this.films.end();
      take(name, texts);
    };
    this.tell = tell;
    this.grid = new Grid(need(root, ".carts-measured-grid tbody"), changed);
    this.paste = /** @type {HTMLTextAreaElement} */ (need(root, ".carts-measured-paste textarea"));
    this.paste.addEventListener("input", changed);
    const file = /** @type {HTMLInputElement} */ (need(root, ".carts-measured-file"));
    this.#enable(false);
    this.on("open", () => file.click());
    this.on("take", () => this.take(tr("pasted readings"), [this.paste.value]));
    this.on("typed-take", () => this.take(TYPED, [this.grid.text]));
    this.on("more", () => this.grid.grow());
    file.addEventListener("change", () => {
      void this.files([...(file.files ?? [])]);
      file.value = "";
    });
    // A file may be dropped anywhere on it.
    area.addEventListener("dragover", (event) => event.preventDefault());
    area.addEventListener("drop", (event) => {
      event.preventDefault();
      const { dataTransfer } = /** @type {DragEvent} */ (event);
      void this.files([...(dataTransfer?.files ?? [])]);
    });
  }

  /** From now on it takes readings. @param {import("../../../view/measured/types.js").Kept} kept what was typed before */
  open({ cells, pasted }) {
    if (cells.length) this.grid.cells = cells;
    this.paste.value = pasted ?? "";
    this.#enable(true);
    this.#open(undefined);
  }

  /** @param {boolean} on */
  #enable(on) {
    for (const input of this.root.querySelectorAll("button, textarea, select, input")) {
      /** @type {HTMLInputElement} */ (input).disabled = !on;
    }
  }

  /** What was typed. */
  get typed() {
    return { cells: this.grid.cells, pasted: this.paste.value };
  }

  /** @param {string} name @param {() => void} act */
  on(name, act) {
    this.root.querySelector(`.carts-measured-${name}`)?.addEventListener("click", act);
  }

  /** @param {File[]} files one with both carts, or one for each */
  async files(files) {
    if (!files.length) return;
    await this.#opened;
    const film = files.find(isFilm);
    if (film) return this.films.open(film);
    if (files.length > 2) return this.tell(tr("Choose one file with both carts, or one for each."));
    for (const { name, size } of files) {
      const most = ZIP_NAME.test(name) ? MOST_ZIPPED : MOST_BYTES;
      if (size <= most) continue;
      const limit = tr("at most {most} MB", { most: most / 1e6 });
      return this.tell(
        tr("This file is too large to be readings of two carts: {limit}.", { limit }),
      );
    }
    const texts = [];
    for (const file of files) {
      const bytes = await file.arrayBuffer().catch(() => null); // a folder, or a file that is gone
      if (!bytes) return this.tell(Source.notRead(file.name) + tr("choose a file that is there."));
      const found = isZip(bytes) ? await this.#unzipped(bytes) : { text: decoded(bytes) };
      if ("refused" in found) {
        const why = found.refused.map((fault) => Source.hinted(file.name, fault));
        return this.tell(Source.notRead(file.name) + why.join(". "));
      }
      texts.push(found.text);
    }
    this.take(listed(files.map((file) => file.name)), texts);
  }

  /** @param {ArrayBuffer} bytes @returns {Promise<{text: string} | Refused>} */
  #unzipped(bytes) {
    return this.unzip(base64(bytes)).catch(({ message }) => ({
      refused: [{ line: null, reason: message, hint: tr("a zip needs Python to be opened") }],
    }));
  }

  /** @param {string} name @param {string[]} texts */
  save(name, texts) {
    if (!texts.length)
      say(need(this.root, ".carts-measured-said"), tr("There are no readings yet."));
    const own = texts.length === 1 && FILE_NAME.test(name) && !ZIP_NAME.test(name);
    const one = own ? name : "readings.txt";
    for (const text of texts) download(one, text, "text/plain;charset=utf-8");
  }

  /** A message with the lines that it names called so too. @param {string} name @param {Said} reason @returns {string} */
  static told(name, reason) {
    return told(withPlaces(name, reason));
  }

  /** The same with what helps. @param {string} name @param {{reason: Said, hint: Said}} fault */
  static hinted(name, { reason, hint }) {
    const found = Source.told(name, reason);
    return hint ? tr("{reason} ({hint})", { reason: found, hint: told(hint) }) : found;
  }

  /** What readings are called. @param {string} name @returns {string} */
  static called(name) {
    return name === TYPED ? tr("typed readings") : name;
  }

  /** Whose faults are told. @param {string} name */
  static notRead(name) {
    if (!name || name === TYPED) return "";
    const told = tr("{name} was not read:", { name });
    return `${told} `;
  }

  /** What a line of a text is called where it stands. @param {string} name @param {number} line */
  static place(name, line) {
    if (name !== TYPED) return tr("line {line}", { line });
    return line > 1 ? tr("row {row}", { row: line - 1 }) : tr("the table");
  }
}

/** @param {string} name of the readings @param {Said} reason @returns {Said} with every line in it as it is called there */
function withPlaces(name, reason) {
  if (typeof reason === "string") return reason;
  if (reason.code === LINE) return Source.place(name, Number(reason.values.line));
  const values = Object.entries(reason.values).map(([key, value]) => [
    key,
    withPlaces(name, value),
  ]);
  return { ...reason, values: Object.fromEntries(values) };
}

/** @param {ArrayBuffer} bytes */
function isZip(bytes) {
  return new DataView(bytes).byteLength > 4 && new DataView(bytes).getUint32(0) === ZIP;
}

/** @param {ArrayBuffer} bytes */
function base64(bytes) {
  let text = "";
  for (const byte of new Uint8Array(bytes)) text += String.fromCharCode(byte);
  return btoa(text);
}
