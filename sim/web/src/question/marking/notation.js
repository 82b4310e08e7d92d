/** How numbers and units are written: the same rules as sim/scene/notation.py, held by tests/marking. */

/** @type {Record<string, string>} */
const RAISED = { "⁻": "-", "⁺": "+" };
for (const [digit, raised] of [..."⁰¹²³⁴⁵⁶⁷⁸⁹"].entries()) RAISED[raised] = String(digit);
const FACTOR =
  /\s*([/·⋅*.]?)\s*([A-Za-zµ°%]+)(?:([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)|(?:\^|\*\*)\(?([+-]?\d(?:\.\d|\/\d)?)\)?|([+-]?\d))?/y;
const POWER_OF_TEN =
  /\s*[×xX*·]\s*10(?:([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3})|\s*(?:\^|\*\*)\s*(\(?[+-]?\d{1,3}\)?))/;
const LONGEST = 30;

/** @param {string} text */
const plain = (text) => text.replace(/[−‐‑–]/g, "-").replace(/μ/g, "µ");
/** @param {string} text */
const lowered = (text) => [...text].map((sign) => RAISED[sign] ?? sign).join("");

/** @param {string} power @returns {number} also of “3/2” */
function number(power) {
  const [above, below] = power.split("/").map(Number);
  return Number(above) / (below ?? 1);
}

/** The symbols of a unit with their powers, sorted, as one text; null where it cannot be read. */
/** @param {string} unit @returns {string | null} */
function factors(unit) {
  const text = plain(unit.trim());
  if (!text || text.length > LONGEST) return null;
  /** @type {Map<string, number>} */
  const powers = new Map();
  for (let at = 0; at < text.length; at = FACTOR.lastIndex) {
    FACTOR.lastIndex = at;
    const found = FACTOR.exec(text);
    if (!found || (at === 0 && found[1])) return null;
    const power = number(lowered(found[3] ?? "") || found[4] || found[5] || "1");
    const symbol = String(found[2]);
    powers.set(symbol, (powers.get(symbol) ?? 0) + (found[1] === "/" ? -power : power));
  }
  return [...powers]
    .map(([symbol, power]) => `${symbol}^${power}`)
    .sort()
    .join(" ");
}

/** Whether two texts are one unit, written in two ways. @param {string} one @param {string} other */
export function sameUnit(one, other) {
  const read = factors(one);
  return one === other || (read !== null && read === factors(other));
}

/** The text with a power of ten as programs write it: 8×10⁻¹ becomes 8e-1. @param {string} text */
export function withExponent(text) {
  return plain(text).replace(POWER_OF_TEN, (_, raised, power) => {
    return `e${lowered(raised ?? power).replace(/[()]/g, "")}`;
  });
}
