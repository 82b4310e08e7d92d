/**
 * Colours of the bands of a map, made in OKLab so that equal steps look equal. From low to high: dark blue
 * over green to light yellow, ever lighter. Around zero: blue for minus, orange for plus, white at zero.
 * Lightness alone tells the order, so the colours work for colour-blind readers and on a printer without
 * colours. OKLab: B. Ottosson, 2020.
 */

/** @typedef {[number, number, number]} Colour sRGB, 0 to 255 */

/** Where a map has no value. @type {Colour} */
export const NONE = [176, 176, 176];
/** The line of zero. @type {Colour} */
export const ZERO = [32, 32, 32];
const EDGE = 0.72; // of a band's colour, on its edge towards the next band: the contour line

/** From low to high. @param {number} count @returns {Colour[]} */
export function sequential(count) {
  return Array.from({ length: count }, (_, k) => {
    const t = k / Math.max(1, count - 1);
    return oklch(0.3 + 0.64 * t, 0.09 + 0.05 * Math.sin(Math.PI * t), 268 - 165 * t);
  });
}

/** For bands with these centres, some below and some above zero: equal size, equal lightness. @param {number[]} centres @returns {Colour[]} */
export function diverging(centres) {
  const far = Math.max(...centres.map(Math.abs));
  return centres.map((centre) => {
    const size = Math.abs(centre / far);
    return oklch(0.97 - 0.47 * size, 0.145 * size, centre < 0 ? 250 : 52);
  });
}

/** Of the contour line on a band. @param {Colour} colour @returns {Colour} */
export function edge([red, green, blue]) {
  return [Math.round(EDGE * red), Math.round(EDGE * green), Math.round(EDGE * blue)];
}

/** sRGB of a colour in OKLCH. @param {number} lightness @param {number} chroma @param {number} hue in degrees @returns {Colour} */
function oklch(lightness, chroma, hue) {
  const angle = (hue * Math.PI) / 180;
  const [a, b] = [chroma * Math.cos(angle), chroma * Math.sin(angle)];
  const long = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const middle = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const short = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    channel(4.0767416621 * long - 3.3077115913 * middle + 0.2309699292 * short),
    channel(-1.2684380046 * long + 2.6097574011 * middle - 0.3413193965 * short),
    channel(-0.0041960863 * long - 0.7034186147 * middle + 1.707614701 * short),
  ];
}

/** @param {number} linear */
function channel(linear) {
  const light = Math.min(1, Math.max(0, linear));
  const coded = light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
  return Math.round(255 * coded);
}
