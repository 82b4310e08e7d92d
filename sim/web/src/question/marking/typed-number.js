/** A number that a student typed, in the question's own unit. The same rules as sim/lesson/typed.py. */

const LONGEST = 40;
const NUMBER = /^([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(.*)$/;
const GROUPED = /^([+-]?[1-9]\d{0,2}(?:,\d{3})+)(?![\d,])/;

/**
 * @param {string} typed @param {Record<string, number>} units how many of the question's unit each allowed unit is
 * @returns {{value: number} | {problem: string}}
 */
export function readNumber(typed, units) {
  const text = typed.trim().replace(/[−–]/g, "-");
  if (!text) return { problem: "Type a number, for example 0.5" };
  if (text.length > LONGEST) return { problem: "That is too long for a number." };
  const grouped = GROUPED.exec(text);
  if (grouped) return { problem: twoReadings(String(grouped[1])) };
  const found = NUMBER.exec(text);
  if (!found) return { problem: `“${text}” is not a number. Type for example 0.5` };
  const number = String(found[1]);
  const unit = (found[2] ?? "").replace(/μ/g, "µ");
  const factor = unit ? (Object.hasOwn(units, unit) ? units[unit] : undefined) : 1;
  if (factor === undefined) {
    const known = Object.keys(units).filter(Boolean).join(", ");
    return { problem: `“${found[2]}” does not fit here. Units: ${known}` };
  }
  const value = Number(number.replace(",", ".")) * factor;
  return Number.isFinite(value) ? { value } : { problem: `${text} is too large.` };
}

/** @param {string} text */
function twoReadings(text) {
  const whole = text.replaceAll(",", "");
  if (text.split(",").length > 2) return `Type ${whole} without commas.`;
  const decimal = String(Number(text.replace(",", ".")));
  return `${text} can mean ${decimal} or ${whole}: type ${decimal} or ${whole}`;
}
