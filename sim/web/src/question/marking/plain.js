/** A text as it is compared: small letters, one minus, no punctuation, single spaces. @param {string} text */
export function plain(text) {
  return text
    .toLowerCase()
    .replace(/[−–]/g, "-")
    .replace(/[\s.,;:!?“”„"'’`()。，、！？；：（）「」『』«»‹›‘…¿¡]+/g, " ")
    .trim();
}
