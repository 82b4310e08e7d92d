/**
 * The reader's language. An English sentence is its own key; a page in another language brings a
 * catalogue along (`sim/pages/language`). Without one, or without that sentence, English stands.
 */

/** @type {Record<string, string>} */
const catalogue = /** @type {any} */ (globalThis).cartsWords ?? {};

/**
 * A sentence in the reader's language. It must stand here as text, so that it is found for the
 * catalogues; what changes in it stands as {name}.
 * @param {string} sentence @param {Record<string, string | number>} values @returns {string}
 */
export function tr(sentence, values = {}) {
  return filled(catalogue[sentence] ?? sentence, values);
}

/** @param {string} sentence @param {Record<string, string | number>} values */
function filled(sentence, values) {
  return sentence.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
}

/** @type {[RegExp, string][] | null} of sentences that come from Python, those with most text first */
let patterns = null;

/**
 * A sentence that Python made, in English: told in the reader's language where the catalogue has a
 * sentence of its form. What stands at its {names} is told the same way.
 * @param {string} english @returns {string}
 */
export function heard(english) {
  if (catalogue[english]) return catalogue[english];
  patterns ??= Object.keys(catalogue)
    .filter((key) => key.includes("{"))
    .sort((a, b) => plain(b).length - plain(a).length)
    .map((key) => [pattern(key), key]);
  for (const [form, key] of patterns) {
    const found = form.exec(english);
    if (!found) continue;
    const parts = Object.entries(found.groups ?? {});
    return filled(
      catalogue[key] ?? key,
      Object.fromEntries(parts.map(([name, part]) => [name, heard(part)])),
    );
  }
  return english;
}

/** @param {string} key */
const plain = (key) => key.replace(/\{\w+\}/g, "");

/** @param {string} key @returns {RegExp} what a sentence of this form looks like */
function pattern(key) {
  const parts = key.split(/\{(\w+)\}/);
  const escaped = parts.map((part, k) =>
    k % 2 ? `(?<${part}>.+?)` : part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"),
  );
  return new RegExp(`^${escaped.join("")}$`, "su");
}
