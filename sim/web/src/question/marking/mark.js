/**
 * Marking in the page, equal to sim/lesson/kinds: tests/marking holds the two together.
 *
 * @typedef {{verdict: "right" | "partly" | "wrong" | "open" | "empty" | "unclear", marks: number | null,
 *   of: number, shown: string[], beliefs: string[]}} Mark
 * @typedef {Record<string, any>} Facts of a question, with its key
 */

import { isEmpty } from "../../answers/entry.js";
import { linkName } from "./link-name.js";
import { plain } from "./plain.js";

const NEAR = 1 + 1e-9; // a number on the edge of the tolerance is inside, whatever its last bit
const LAST_BITS = 1e-12; // of the answer: 70 cm/s are 0.7 m/s also where the tolerance is 0

/**
 * @param {Facts} facts @param {any} value the answer @param {number | null} own the quantity in the student's own run
 * @returns {Mark}
 */
export function mark(facts, value, own = null) {
  const of = facts.marks;
  if (isEmpty(value)) return made("empty", 0, of);
  const rule = RULES[facts.type];
  if (!rule) return made("unclear", 0, of);
  return rule(facts, value, own);
}

/** @type {Record<string, (facts: Facts, value: any, own: number | null) => Mark>} */
const RULES = {
  single({ options, key, marks }, value) {
    if (!options.includes(value)) return made("unclear", 0, marks);
    return chosen([value], key, key.correct.includes(value), false, marks);
  },

  multiple({ options, key, marks }, value) {
    if (!Array.isArray(value) || !value.every((item) => options.includes(item))) {
      return made("unclear", 0, marks);
    }
    const picked = options.filter((/** @type {string} */ item) => value.includes(item));
    const right = picked.filter((/** @type {string} */ item) => key.correct.includes(item));
    const exact = right.length === picked.length && right.length === key.correct.length;
    return chosen(picked, key, exact, right.length > 0, marks);
  },

  number: ({ key, marks }, value) => near(value, key.answer, key.tolerance, marks, key),

  reading({ key, marks }, value, own) {
    if (own === null) return made("open", null, marks);
    return near(value, own, key.relative ? Math.abs(own) * key.tolerance : key.tolerance, marks);
  },

  long: ({ marks }, value) => written(value, marks),

  short({ key, marks }, value) {
    if (typeof value !== "string" || !key.accept.length) return written(value, marks);
    const said = plain(value);
    const named = (/** @type {string[]} */ texts) => texts.some((text) => plain(text) === said);
    if (named(key.accept)) return whole(true, false, marks);
    const k = key.wrong.findIndex((/** @type {any} */ known) => named(known.texts));
    return known(key, k, marks);
  },

  ordering({ key, marks }, value) {
    const right = key.order;
    const same = Array.isArray(value) && [...value].sort().join() === [...right].sort().join();
    if (!same) return made("unclear", 0, marks);
    const followed = right
      .slice(1)
      .map((/** @type {string} */ line, /** @type {number} */ k) => `${right[k]}${line}`);
    const kept = value
      .slice(1)
      .filter((/** @type {string} */ line, /** @type {number} */ k) =>
        followed.includes(`${value[k]}${line}`),
      );
    return whole(value.join() === right.join(), 2 * kept.length >= followed.length, marks);
  },

  matching({ key, right, marks }, value) {
    const entries = Object.entries(value);
    const fits = !Array.isArray(value) && typeof value === "object";
    if (!fits || !entries.every(([left, letter]) => left in key.pairs && right.includes(letter))) {
      return made("unclear", 0, marks);
    }
    const names = Object.keys(key.pairs);
    const good = names.filter((left) => value[left] === key.pairs[left]);
    const shown = good.map((left) => `pair-${left}`);
    return whole(good.length === names.length, good.length > 0, marks, shown);
  },

  table({ key, marks }, value) {
    const names = Object.keys(key.cells);
    const fits = typeof value === "object" && !Array.isArray(value);
    if (!fits || !Object.keys(value).every((name) => names.includes(name))) {
      return made("unclear", 0, marks);
    }
    const good = names.filter((name) => {
      const { answer, tolerance } = key.cells[name];
      return near(value[name], answer, tolerance, 1).verdict === "right";
    });
    const shown = good.map((name) => `cell-${name}`);
    return whole(good.length === names.length, good.length > 0, marks, shown);
  },

  interactions: ({ objects, key, marks }, value) => {
    const drawn = Array.isArray(value)
      ? value.map((link) => linkName(objects, link?.between, link?.by))
      : [""];
    if (drawn.includes("")) return made("unclear", 0, marks);
    const right = key.links.map((/** @type {any} */ link) =>
      linkName(objects, link.between, link.by),
    );
    const lost = right.filter((/** @type {string} */ link) => !drawn.includes(link));
    const invented = drawn.filter((link) => !right.includes(link));
    const fits = (/** @type {any} */ row, /** @type {string[]} */ links) =>
      row.by.some((/** @type {string} */ by) => links.includes(linkName(objects, row.between, by)));
    const told = (/** @type {string} */ name, /** @type {string[]} */ links) =>
      key[name]
        .map((/** @type {any} */ row, /** @type {number} */ k) =>
          fits(row, links) ? `${name}-${k + 1}` : "",
        )
        .filter((/** @type {string} */ row) => key.feedback.includes(row));
    const good = right.filter((/** @type {string} */ link) => drawn.includes(link));
    const names = good.map((/** @type {string} */ link) => `link-${link}`);
    const shown = [...names, ...told("missing", lost).slice(0, 1), ...told("wrong", invented)];
    const rows = key.wrong.filter((/** @type {any} */ row) => row.belief && fits(row, invented));
    const beliefs = rows.map((/** @type {any} */ row) => row.belief);
    const half = !invented.length && 2 * lost.length <= right.length;
    return whole(!lost.length && !invented.length, half, marks, shown, beliefs);
  },

  confidence: ({ options }, value) =>
    options.includes(value) ? made("open", null, 0) : made("unclear", null, 0),

  drawn: () => made("open", null, 0),

  idea: ({ options }, value) =>
    typeof value === "string" && (!options.length || options.includes(value))
      ? made("open", null, 0)
      : made("unclear", null, 0),
};

/** @param {Mark["verdict"]} verdict @param {number | null} marks @param {number} of @param {string[]} shown @param {string[]} beliefs @returns {Mark} */
function made(verdict, marks, of, shown = [], beliefs = []) {
  return { verdict, marks, of, shown, beliefs };
}

/** The mark of an item that gives its marks only as a whole. */
/** @param {boolean} right @param {boolean} some @param {number} of @param {string[]} shown @param {string[]} beliefs @returns {Mark} */
function whole(right, some, of, shown = [], beliefs = []) {
  if (right) return made("right", of, of, [...shown, "explain"]);
  return made(some ? "partly" : "wrong", 0, of, shown, beliefs);
}

/** @param {string[]} picked @param {any} key @param {boolean} right @param {boolean} some @param {number} of */
function chosen(picked, key, right, some, of) {
  const shown = picked
    .map((item) => `option-${item}`)
    .filter((name) => key.feedback.includes(name));
  const beliefs = picked.flatMap((item) =>
    Object.hasOwn(key.beliefs, item) ? key.beliefs[item] : [],
  );
  return whole(right, some, of, shown, beliefs);
}

/** What is no text nobody can read: no question may wait for that. @param {any} value @param {number} of */
function written(value, of) {
  return typeof value === "string" ? made("open", null, of, ["explain"]) : made("unclear", 0, of);
}

/** A wrong answer that is known, or not (k = −1). @param {any} key @param {number} k @param {number} of */
function known(key, k, of) {
  if (k < 0) return whole(false, false, of);
  const shown = key.feedback.includes(`wrong-${k}`) ? [`wrong-${k}`] : [];
  return whole(false, false, of, shown, key.wrong[k].belief ? [key.wrong[k].belief] : []);
}

/** @param {any} value @param {number} answer @param {number} tolerance @param {number} of @param {any} key with known wrong answers */
function near(value, answer, tolerance, of, key = null) {
  if (typeof value !== "number" || !Number.isFinite(value)) return made("unclear", 0, of);
  const edge = tolerance * NEAR + LAST_BITS * Math.abs(answer);
  if (Math.abs(value - answer) <= edge) return whole(true, false, of);
  const k = (key?.wrong ?? []).findIndex(
    (/** @type {any} */ wrong) => Math.abs(value - wrong.value) <= wrong.tolerance * NEAR,
  );
  return known(key, k, of);
}
