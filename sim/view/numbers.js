/** Numbers as text. A real minus sign; never “−0”. */

const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
/** Of the scale of a quantity: less is rounding, and drawn and told as zero. */
export const NOISE = 1e-9;
const MAX_DECIMALS = 12;
const SLOW = 0.01; // m/s; scenes with no greater speed speak of mm/s

/** @param {number} value @returns {number} the power of ten of the first digit; 0 for 0 */
export function exponent(value) {
  return value ? Number(Math.abs(value).toExponential(16).split("e")[1]) : 0;
}

/** @param {number} value @param {number} decimals @returns {string} for example 0.60 or −1.25 */
export function fixed(value, decimals) {
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && /[1-9]/.test(text) ? `−${text}` : text;
}

/** @param {number} scale @returns {number} decimals that show a value as large as `scale` */
export function decimalsFor(scale, figures = 3) {
  return Math.min(MAX_DECIMALS, Math.max(0, figures - 1 - exponent(scale)));
}

/** @param {number} value @returns {string} without trailing zeros: 0.5, 1.25, 1.5 × 10⁹ */
export function short(value, figures = 3) {
  const power = exponent(value);
  if (value && (power <= -4 || power >= 6)) {
    const [digits = "", tens] = Math.abs(value)
      .toExponential(figures - 1)
      .split("e");
    return `${value < 0 ? "−" : ""}${trim(digits)} × 10${superscript(Number(tens))}`;
  }
  return trim(fixed(value, Math.max(0, figures - 1 - power)));
}

/** @param {number} value @returns {string} with its figures, zeros too: 0.300 beside 0.288 */
export function figures(value, count = 3) {
  const power = exponent(value);
  return power <= -4 || power >= 6 ? short(value, count) : fixed(value, decimalsFor(value, count));
}

/** @param {number} power a whole number @returns {string} ⁻³ */
export function superscript(power) {
  const digits = String(Math.abs(power)).replace(/\d/g, (d) => SUPERSCRIPT[Number(d)] ?? "");
  return power < 0 ? `⁻${digits}` : digits;
}

/** @param {number} value @returns {number} decimals that show up to so many figures, without trailing zeros */
export function decimalsOf(value, figures = 6) {
  const text = Math.abs(value).toFixed(decimalsFor(value, figures));
  return trim(text).split(".")[1]?.length ?? 0;
}

/** @param {number} scale greatest speed of a scene @returns {[number, string]} m/s in the unit of its velocities; its name */
export function speedUnit(scale) {
  return scale <= SLOW ? [0.001, "mm/s"] : [1, "m/s"];
}

/** @param {string} text */
function trim(text) {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

/** @param {number} value @returns {string} a drawing coordinate, rounded */
export function px(value, decimals = 1) {
  const factor = 10 ** decimals;
  const rounded = Math.floor(value * factor + 0.5) / factor;
  return String(rounded === 0 ? 0 : rounded);
}
