/** What the teacher has dropped on the page so far. Nothing of it is kept when the page is closed. */

import { tr } from "../../../view/language.js";
import { codeWord } from "../shared/code-word.js";
import { inFull } from "./brought-along.js";
import { Names } from "./nameless.js";

/** @typedef {any[]} Row a file as Python handed it over: name, site, lesson, …, see sim/classroom/files/records.py */
/** @typedef {{row: Row, group: number, out: boolean, named?: boolean}} Held `out`: left out by the teacher; `named`: its code word was typed here */
/** @typedef {{lesson: string, form: string, student: string, item: string, marks: number}} GivenMark */
/** @typedef {{name: string, base64: string, form: string, group: number}} Table marks from elsewhere; form: pre, post, later or "" */
/** @typedef {{records: Row[], keys: string[], marks: GivenMark[], refused: [string, string][], next: number | null}} Found */

export const WHOLE = "class";
const [NAME, STUDENT, CREATED] = [0, 4, 6]; // places in a row, see sim/classroom/files/records.py

export class Classroom {
  /** @type {Held[]} */
  files = [];
  nameless = new Names(); // the names of files without a code word
  /** @type {string[]} the texts of key files */
  keys = [];
  /** @type {string[]} the same for what can be practised: this site brings them along */
  practice = inFull(/** @type {any} */ (globalThis).__cartsKeys ?? []);
  /** @type {Map<string, GivenMark>} */
  marks = new Map();
  /** @type {[string, string][]} */
  refused = [];
  codes = ["", ""]; // as typed, of each group
  unfiled = false; // marks of this visit are in no file
  /** @type {Table[]} */
  tables = [];
  most = ""; // marks of the tests in them, as typed
  two = false;
  /** @type {[string, string]} */
  names = [tr("experimental"), tr("control")];

  /** @returns {boolean} whether there is nothing here */
  get empty() {
    return this.noAnswers && !this.tables.length;
  }

  /** @returns {boolean} whether there is nothing here but tables */
  get noAnswers() {
    return !this.files.length && !this.keys.length && !this.refused.length && !this.typed;
  }

  /** @returns {boolean} whether a code was typed */
  get typed() {
    return this.codes.some(Boolean);
  }

  /** @returns {boolean} whether marks, codes or code words of this visit are nowhere else */
  get unsaved() {
    return this.unfiled || this.typed || this.files.some(({ named }) => named);
  }

  /** @returns {string[]} the names of the groups, each once */
  get groups() {
    if (!this.two) return [WHOLE];
    const [one, other] = this.names.map((name, k) => name.trim() || tr("group {n}", { n: k + 1 }));
    return [one ?? "", one === other ? `${other} (2)` : (other ?? "")];
  }

  /** @param {Found} found @param {number} group */
  take(found, group) {
    for (const row of found.records) {
      if (!row[STUDENT].trim()) row[NAME] = this.nameless.of(row[NAME], row[CREATED]);
      this.files.push({ row, group, out: false });
    }
    for (const key of found.keys) if (!this.keys.includes(key)) this.keys.push(key);
    for (const mark of found.marks) this.give(mark);
    this.refused.push(...found.refused);
  }

  /** @param {GivenMark} mark */
  give(mark) {
    const { lesson, form, student, item } = mark;
    this.marks.set(JSON.stringify([lesson, form, codeWord(student), item]), mark);
  }

  /** A mark that the teacher gives here; those of a file are given, too, and saved already. @param {GivenMark} mark */
  mark(mark) {
    this.unfiled = true;
    this.give(mark);
  }

  /** Says whose a file is that does not tell it. Marks that were given to it go along. @param {Held} file @param {string} typed */
  name(file, typed) {
    const before = this.#who(file);
    file.row[STUDENT] = codeWord(typed);
    file.named = true;
    if (this.files.some((other) => this.#who(other) === before)) return; // they are that one's
    const [, , lesson, , , form] = file.row;
    for (const [key, mark] of [...this.marks]) {
      if (mark.lesson !== lesson || mark.form !== form || codeWord(mark.student) !== before)
        continue;
      this.marks.delete(key);
      this.give({ ...mark, student: this.#who(file) });
    }
  }

  /** Whose marks they are: as `Marked.who` of sim/classroom/report/marked.py says it. @param {Held} file */
  #who({ row }) {
    return codeWord(row[STUDENT] || `no code word (${row[NAME]})`);
  }

  /** What Python is told with every question. @returns {Record<string, unknown>} */
  told() {
    const { groups } = this;
    return {
      kind: "class",
      records: this.files
        .filter((file) => !file.out)
        .map(({ row, group }) => [row, groups[this.two ? group : 0]]),
      keys: [...this.practice, ...this.keys], // of one form the later one counts
      marks: [...this.marks.values()],
      refused: this.refused,
      codes: this.codes,
      groups,
      now: new Date().toISOString(),
    };
  }

  /** The same of the tables of marks, those of the first group first. @returns {Record<string, unknown>} */
  toldOfTables() {
    const { groups } = this;
    const of = (/** @type {Table} */ table) => (this.two ? table.group : 0);
    const tables = [...this.tables]
      .sort((one, other) => of(one) - of(other))
      .map((table) => ({ ...table, group: groups[of(table)] }));
    return { kind: "class", tables, most: this.most };
  }

  /** Both reports, as far as there is something of each. @returns {Record<string, unknown>} */
  toldOfAll() {
    return {
      ...(this.noAnswers ? {} : this.told()),
      ...(this.tables.length ? this.toldOfTables() : {}),
    };
  }

  /** One group, or two: codes that were typed for the second go to the first. @param {boolean} two */
  divide(two) {
    this.two = two;
    if (!two) this.codes = [this.codes.filter(Boolean).join("\n"), ""];
  }

  /** @param {number} group @param {string} text */
  typeCodes(group, text) {
    this.codes[group] = text;
  }

  /** @returns {string} the text of a file with the teacher's marks */
  marksFile() {
    const rows = [...this.marks.values()].map((mark) => ({
      ...mark,
      student: codeWord(mark.student),
    }));
    return `${JSON.stringify({ format: 1, kind: "newtons-carts-marks", marks: rows }, null, 1)}\n`;
  }
}
