/**
 * Answers in words as they are compared: sim/lesson/kinds/plain_words.py says what counts and what not.
 */

const POINT = "\ue000"; // stands for the point of a number while others are dropped; no text has it

/** A text as it is compared; empty for one that is nothing but punctuation. @param {string} text */
export function plain(text) {
  return text
    .replace(/´/g, "'")
    .replace(/[⁺⁻⁰¹²³⁴-⁹]+/g, "^$&") // NFKC alone makes 102 of 10²
    .normalize("NFKC")
    .toLowerCase()
    .replace(/[−–‐]/g, "-")
    .replaceAll(POINT, "")
    .replace(/[.,]*[0-9]+(?:[.,]+[0-9]+)*/g, number)
    .replace(/[\s.,;:!?“”„"'’`()。、«»‹›‘…¿¡「」『』]+/g, " ")
    .replace(/^ | $/g, "")
    .replace(/ ?([=+\-*/·×÷<>≤≥≈±^%°|&]) ?/g, "$1")
    .replace(/([0-9]) ([^0-9 ])/g, "$1$2")
    .replace(/([^0-9 ]) ([0-9])/g, "$1$2")
    .replaceAll(POINT, ".");
}

/** One number with its point kept; of 1,2,3 and of “no.5” the signs are punctuation. @param {string} found @param {number} at @param {string} whole */
function number(found, at, whole) {
  const one = /^([0-9]*)[.,]([0-9]+)$/.exec(found);
  const glued = one && !one[1] && /\p{L}$/u.test(whole.slice(Math.max(0, at - 2), at));
  if (!one || glued) return found.replace(/[.,]/g, " ");
  return `${one[1] || 0}${POINT}${one[2]}`;
}
