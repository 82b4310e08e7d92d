/** A number that a student typed, in the question's own unit. */

import { tr } from "../../../../view/language.js";
import { tidy, twoReadings } from "../../shared/typed.js";
import { sameUnit, withExponent } from "./notation.js";

const LONGEST = 40;
const NUMBER = /^([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(.*)$/;

const BARE = /^[\s+\-−–±\d.,eE]*$/; // a number without a unit, or a value with its interval

// the interval of “0.741 ± 0.017 m/s”, as a table of results has it: the value is what is asked for
const INTERVAL = /^\(?(.+?)\s*(?:±|\+\/?-)\s*[\d.,]+\)?/;

/** What was typed, in words: a bare number with the question's unit. @param {string} typed @param {string} unit */
export function withUnit(typed, unit) {
  const text = typed.trim();
  return text && unit && BARE.test(tidy(text)) ? `${text} ${unit}` : text;
}

/** As it stands in its box, behind which the unit stands. @param {string} said @param {string} unit */
export function withoutUnit(said, unit) {
  return unit && said.endsWith(` ${unit}`) ? said.slice(0, -unit.length - 1) : said;
}

/**
 * @param {string} typed @param {Record<string, number>} units how many of the question's unit each allowed unit is
 * @returns {{value: number} | {problem: string}}
 */
export function readNumber(typed, units) {
  const text = withExponent(tidy(typed)).replace(INTERVAL, "$1");
  if (!text) return { problem: tr("Type a number, for example 0.5") };
  if (text.length > LONGEST) return { problem: tr("That is too long for a number.") };
  const grouped = twoReadings(text);
  if (grouped) return { problem: grouped };
  const found = NUMBER.exec(text);
  if (!found || /^[.,]/.test(found[2] ?? ""))
    return { problem: tr("“{text}” is not a number. Type for example 0.5", { text }) };
  const number = String(found[1]);
  const unit = (found[2] ?? "").replace(/(.)\.$/, "$1").replace(/\bK[gG]\b/, "kg");
  const known = Object.keys(units).filter(Boolean);
  const own = unit ? known.find((one) => sameUnit(one, unit)) : "";
  const factor = unit ? (own ? units[own] : undefined) : 1;
  if (factor === undefined) return { problem: unfit(unit, units) };
  // To the digits that a unit leaves: 35 cm/s are 0.35 m/s, not 0.35000000000000003.
  const value = Number((Number(number.replace(",", ".")) * factor).toPrecision(15));
  return Number.isFinite(value) ? { value } : { problem: tr("{text} is too large.", { text }) };
}

/** Why what stands behind the number is no unit of the question. @param {string} unit @param {Record<string, number>} units */
function unfit(unit, units) {
  if (/^\/\s*\d/.test(unit))
    return tr("A fraction is not read here: work it out and type for example 0.5");
  const [own = "", ...others] = Object.keys(units); // that of the question first; %: of a plain number
  if (!own) return tr("“{unit}” does not fit here: it is a number without a unit.", { unit });
  const close = (/** @type {string} */ one) => one.replace(/\s/g, "");
  const told = [own, ...others].filter(
    (one, place, all) =>
      one &&
      (one === own || !one.includes("⁻")) &&
      !all.slice(0, place).some((other) => close(other) === close(one)),
  );
  return tr("“{unit}” does not fit here. Units: {units}", { unit, units: told.join(", ") });
}
