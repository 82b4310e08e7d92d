/** Code words of students, from a printed card: BLUE-FOX-27. Two on one laptop: BLUE-FOX-27+RED-OWL-13. */

import { tr } from "../../../view/language.js";

const MOST = 80;
const HAN = /\p{Script=Han}/u; // one sign is a syllable, two or three are a name

/**
 * A code word as it is stored, or what is wrong with it.
 * @param {string} typed @returns {{code: string} | {problem: string}}
 */
export function readCode(typed) {
  const parts = typed
    .normalize("NFKC")
    .toUpperCase()
    .split(/\s*[+&]\s*/)
    .map((part) => part.trim().replace(/[\s–—−_]+/g, "-"));
  const codes = [...new Set(parts)].sort();
  const code = codes.join("+");
  if (!typed.trim()) return { problem: tr("Type the code word from your card.") };
  if (code.length > MOST) return { problem: tr("That is too long for a code word.") };
  if (!codes.every((part) => /^[\p{L}\p{N}]+(-[\p{L}\p{N}]+)*$/u.test(part))) {
    return { problem: tr("A code word has letters, digits and hyphens: BLUE-FOX-27") };
  }
  if (codes.some((part) => part.length < (HAN.test(part) ? 2 : 4))) {
    return { problem: tr("A code word has at least four letters or digits.") };
  }
  return { code };
}
