/** Code words of students, from a printed card: BLUE-FOX-27. Two on one laptop: BLUE-FOX-27+RED-OWL-13. */

import { tr } from "../../../view/language.js";
import { codeWord } from "../shared/code-word.js";

const MOST = 80;
const HAN = /\p{Script=Han}/u; // one sign is a syllable, two or three are a name

/**
 * A code word as it is stored, or what is wrong with it.
 * @param {string} typed @returns {{code: string} | {problem: string}}
 */
export function readCode(typed) {
  const code = codeWord(typed);
  const codes = code.split("+");
  if (!typed.trim()) return { problem: tr("Type the code word from your card.") };
  if (code.length > MOST) return { problem: tr("That is too long for a code word.") };
  if (!codes.every((part) => /^[\p{L}\p{M}\p{N}]+(-[\p{L}\p{M}\p{N}]+)*$/u.test(part))) {
    return { problem: tr("A code word has letters, digits and hyphens: BLUE-FOX-27") };
  }
  if (codes.some((part) => part.length < (HAN.test(part) ? 2 : 4))) {
    return { problem: tr("A code word has at least four letters or digits.") };
  }
  return { code };
}
