/** A code word as it is kept and compared; as `pseudonym` of sim/classroom/files/marks_file.py does. */

/** The key under which the code word of who works here is kept. */
export const STUDENT = "student";

/** @param {string} typed @returns {string} “blue fox 27” is BLUE-FOX-27; of two with a + between them in one order */
export function codeWord(typed) {
  const parts = typed
    .normalize("NFKC")
    .toUpperCase()
    .split(/[+&]/)
    .map((part) => part.trim().replace(/[\s–—−_]+/g, "-"));
  return [...new Set(parts)].sort().join("+");
}
