/** What a reader typed as a number. A decimal comma is fine; “1,000” is refused with both readings. */

import { tr } from "../../../view/language.js";
import { withExponent } from "../question/marking/notation.js";

const LONGEST = 40;
const GROUPED = /^[+-]?[1-9]\d{0,2}(,\d{3})+(?![\d,])(\.\d*)?/;

/**
 * A number in the box's own unit, or text with a unit for Python to read, or why it is neither.
 * @param {string} typed @returns {{value: number} | {text: string} | {problem: string}}
 */
export function readTyped(typed) {
  const text = withExponent(tidy(typed));
  if (!text) return { problem: tr("Type a number, for example 0.5") };
  if (text.length > LONGEST) return { problem: tr("That is too long for a number.") };
  const grouped = twoReadings(text);
  if (grouped) return { problem: grouped };
  if (/^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i.test(text)) {
    const value = Number(text.replace(",", "."));
    return Number.isFinite(value) ? { value } : { problem: tr("{text} is too large.", { text }) };
  }
  if (/^[+-]?[\d.,]+(e[+-]?\d+)?\s*[a-zA-Zµ°%][a-zA-Zµ°%⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺^/·⋅*(). \d-]*$/.test(text)) {
    return { text: text.replace(/(\d),(\d)/, "$1.$2") };
  }
  return { problem: noNumber(text) };
}

/** @param {string} text */
export const noNumber = (text) => tr("“{text}” is not a number. Type for example 0.5", { text });

/** What is said of a number beyond a box's range. @param {{label: string, unit: string}} box @param {string} low @param {string} high */
export function outside({ label, unit }, low, high) {
  const range = tr("{low} to {high}", { low, high });
  return tr("{label}: {range}, please.", { label, range: `${range} ${unit}`.trim() });
}

/** What was typed in a box of forces, whose own unit may stand behind it. @param {string} typed */
export const withoutNewtons = (typed) => typed.replace(/\s*N\s*$/i, "");

const APART = /^([+\-−–]?[1-9]\d{0,2})((?:[ \u00a0\u2009\u202f]\d{3})+)(?!\d)/;

/** Figures and signs as wide as a Chinese letter are the same numbers; a sign may stand apart, and thousands. @param {string} typed */
export function tidy(typed) {
  const narrow = (/** @type {string} */ sign) => String.fromCharCode(sign.charCodeAt(0) - 0xfee0);
  return typed
    .trim()
    .replace(/[０-９．，＋－]/g, narrow)
    .replace(/^([+\-−–])\s+(?=[\d.,])/, "$1")
    .replace(APART, (whole) => whole.replace(/\s/g, ""));
}

/** What a comma before three digits can mean, with a unit behind it or none; empty: there is none. @param {string} typed */
export function twoReadings(typed) {
  const text = GROUPED.exec(typed)?.[0];
  if (!text) return "";
  const whole = text.replaceAll(",", "");
  if (/[,.].*[,.]/.test(text)) return tr("Type {number} without commas.", { number: whole });
  const decimal = String(Number(text.replace(",", ".")));
  return tr("{text} can mean {decimal} or {whole}: type {decimal} or {whole}", {
    text,
    decimal,
    whole,
  });
}
