/** The answer file: made, and read with checks. Nothing of a file is taken that is not known. Pure. */

import { tr } from "../../../view/language.js";
import { isEmpty } from "./entry.js";

const FORMAT = 1;
export const KIND = "newtons-carts-answers";
const MOST_BYTES = 2_000_000; // an answer file has some 20 000
const MOST_ITEMS = 2000;
const LONGEST = 20_000; // characters of one answer
const LARGEST = 1e300; // a number
const MOST_TRIES = 1_000_000;
const TEXTS = ["unit", "sure", "said", "asked", "locked", "again", "why", "now"];
const FORMS = ["worksheet", "pre", "post", "delayed"];
const ID = /^[a-z_][a-z0-9-]{0,79}$/; // of a scene, 64 letters, and what was found in it
const HASH = /^[0-9a-f]{12}$/;
const TIME = /^\d{4}-\d{2}-\d{2}T\d{2}:\d{2}:\d{2}(\.\d{1,3})?Z$/;

/**
 * @typedef {{lesson: string, form: string, page: string, name: string, content: any}} AnswerFile
 */

/**
 * One file for each lesson and form of a student.
 * @param {[string, any][]} entries keys and answers @param {{site: string, student: string}} who @param {string} now
 * @returns {AnswerFile[]}
 */
export function makeFiles(entries, { site, student }, now) {
  /** @type {Map<string, {lesson: string, form: string, page: string, kept: any[]}>} */
  const groups = new Map();
  for (const [key, entry] of entries) {
    if (!entry || typeof entry !== "object" || typeof entry.id !== "string") continue;
    const page = key.slice(0, key.lastIndexOf("#")); // a lesson may have a # in its name, an id has none
    const form = FORMS.includes(entry.form) ? entry.form : "worksheet";
    const lesson = entry.lesson ?? page.split("/").pop() ?? "page";
    const name = `${page} ${form}`;
    const group = groups.get(name) ?? { lesson, form, page, kept: /** @type {any[]} */ ([]) };
    group.kept.push(entry);
    groups.set(name, group);
  }
  return [...groups.values()].map(({ lesson, form, page, kept }) => {
    const last = [...kept].sort((a, b) => String(a.last).localeCompare(String(b.last))).pop();
    const state = kept.find((entry) => entry.type === "form");
    const content = {
      format: FORMAT,
      kind: KIND,
      site,
      lesson,
      lessonHash: last?.lessonHash ?? "",
      student,
      form,
      created:
        kept
          .map((entry) => entry.first)
          .filter(Boolean)
          .sort()[0] ?? now,
      saved: now,
      page,
      ...(state?.handed ? { handed: state.handed, code: state.code ?? "" } : {}),
      items: kept.filter((entry) => entry.type !== "form").flatMap(items),
    };
    return { lesson, form, page, name: fileName(content, "carts.json"), content };
  });
}

/** Without a code word by when it was begun: in one folder no file takes the place of another. @param {{lesson: string, form: string, student: string, created: string}} content @param {string} ending */
export function fileName({ lesson, form, student, created }, ending) {
  const safe = (/** @type {string} */ text) =>
    text.replace(/[^\p{L}\p{M}\p{N}+_-]+/gu, "-").slice(0, 80);
  const begun = created
    .slice(5, 19)
    .replace(/[^\dT]/g, "")
    .replace("T", "-");
  return `${safe(lesson)}.${form}.${safe(student) || `no-code-${begun}`}.${ending}`;
}

/** An answer and those to earlier versions of its question. @param {any} entry @returns {any[]} */
function items(entry) {
  const all = [...(entry.earlier ?? []), entry];
  return all.filter((one) => !isEmpty(one.value) || one.tries).map(item);
}

/** @param {any} entry */
function item(entry) {
  const { id, hash = "", type, value, first = null, last = null, tries = 0 } = entry;
  const made = /** @type {Record<string, unknown>} */ ({
    id,
    hash,
    type,
    value,
    first,
    last,
    tries,
  });
  for (const name of [...TEXTS, "own", "set", "found", "right", "before"]) {
    const more = entry[name];
    if (more !== undefined && more !== null && more !== "") made[name] = more;
  }
  return made;
}

/** Why a file of this size is not even read. @param {number} bytes @returns {{problem: string} | null} */
export function tooLarge(bytes) {
  if (bytes <= MOST_BYTES) return null;
  return { problem: tr("This file is too large to be a file of answers.") };
}

/**
 * What a chosen file holds, or why it is not taken.
 * @param {string} text @param {string} site @returns {{student: string, entries: [string, any][], form: string, lesson: string} | {problem: string}}
 */
export function readFile(text, site) {
  const large = tooLarge(text.length);
  if (large) return large;
  /** @type {any} */
  let content;
  try {
    content = JSON.parse(text.replace(/^\uFEFF/, ""));
  } catch {
    return { problem: tr("This file is damaged, or it is not a file of answers.") };
  }
  const problem = wrong(content, site);
  if (problem) return { problem };
  const { page, lesson, form, lessonHash } = content;
  /** @type {Map<string, any>} */
  const found = new Map();
  for (const row of content.items) {
    const entry = clean(row);
    if (!entry)
      return { problem: tr("An answer in this file is damaged. Nothing was taken from it.") };
    const key = form === "worksheet" ? `${page}#${entry.id}` : `${page}#${form}:${entry.id}`;
    const other = found.get(key);
    const full = { ...entry, form, lesson, lessonHash };
    // The last of the same name is today's answer, the others are earlier ones.
    found.set(
      key,
      other
        ? { ...full, earlier: [...(other.earlier ?? []), { ...other, earlier: undefined }] }
        : full,
    );
  }
  if (TIME.test(content.handed ?? "")) found.set(`${page}#${form}:_form`, handedIn(content));
  return { student: content.student, form, lesson, entries: [...found] };
}

/** @param {any} content @param {string} site @returns {string} what is wrong with the whole; empty: nothing */
function wrong(content, site) {
  const isTable = typeof content === "object" && content !== null && !Array.isArray(content);
  if (!isTable || content.kind !== KIND) return tr("This is not a file of answers.");
  if (!Number.isInteger(content.format) || content.format < 1)
    return tr("This is not a file of answers.");
  if (content.format > FORMAT) {
    return tr("This file comes from a newer version of the lessons. Open it there.");
  }
  if (content.site !== site) return tr("This file belongs to another site.");
  const texts = [content.lesson, content.student, content.page].every(
    (text) => typeof text === "string" && text.length <= 200 && !/\p{Cc}/u.test(text),
  );
  const foreign = /[#@]/.test(content.student) || /^@/.test(content.page); // keys of others begin so
  const hash = content.lessonHash === "" || HASH.test(String(content.lessonHash));
  if (!texts || foreign || !hash || !content.page || !FORMS.includes(content.form)) {
    return tr("This file is damaged. Nothing was taken from it.");
  }
  if (!Array.isArray(content.items) || content.items.length > MOST_ITEMS) {
    return tr("This file is damaged. Nothing was taken from it.");
  }
  return "";
}

/** An answer with the known keys only; null: it cannot be one. @param {any} row */
function clean(row) {
  if (typeof row !== "object" || row === null) return null;
  const { id, hash, type, value, first, last, tries } = row;
  const good =
    typeof id === "string" &&
    ID.test(id) &&
    (hash === "" || HASH.test(String(hash))) &&
    typeof type === "string" &&
    /^[a-z][a-z-]{2,23}$/.test(type) &&
    [first, last].every((time) => time === null || TIME.test(String(time))) &&
    Number.isInteger(tries) &&
    tries >= 0 &&
    tries <= MOST_TRIES &&
    isPlain(value, 0);
  if (!good) return null;
  const entry = /** @type {Record<string, unknown>} */ ({
    id,
    hash,
    type,
    value,
    first,
    last,
    tries,
  });
  for (const name of TEXTS) {
    if (typeof row[name] === "string" && row[name].length <= LONGEST) entry[name] = row[name];
  }
  if (Number.isFinite(row.own) && isPlain(row.own, 0)) entry.own = row.own;
  if (isPlain(row.set, 1) && row.set) entry.set = row.set;
  if (Number.isInteger(row.right) && row.right >= 0 && row.right <= tries) entry.right = row.right;
  if (row.before && isPlain(row.before, 0)) entry.before = row.before;
  if (Array.isArray(row.found) && isPlain(row.found, 1)) entry.found = row.found;
  return entry;
}

/** Texts, numbers, short lists and tables of them: all that an answer can be. @param {any} value @param {number} depth @returns {boolean} */
function isPlain(value, depth) {
  if (value === null || value === undefined || typeof value === "boolean") return true;
  if (typeof value === "string") return value.length <= LONGEST;
  if (typeof value === "number") return Math.abs(value) < LARGEST;
  if (depth > 3 || typeof value !== "object") return false;
  const parts = Object.entries(value);
  return (
    parts.length <= 200 &&
    parts.every(
      ([key, part]) =>
        /^[\w.+-]{1,64}$/.test(key) && !key.startsWith("__") && isPlain(part, depth + 1),
    )
  );
}

/** @param {any} content */
function handedIn({ handed, code, created, form, lesson, lessonHash }) {
  const known = typeof code === "string" && /^[0-9A-Z-]{0,14}$/.test(code) ? code : "";
  return {
    id: "_form",
    type: "form",
    form,
    lesson,
    lessonHash,
    value: { handed, code: known },
    handed,
    code: known,
    words: [],
    first: TIME.test(String(created)) ? created : null,
    last: handed,
    tries: 0,
  }; // prettier-ignore
}
