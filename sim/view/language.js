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

/**
 * A sentence as Python sends it: its template, which is its key in the catalogues, and the values in it,
 * which may be such sentences themselves. A word alone is its own key.
 * @typedef {string | {code: string, values: Record<string, Said>}} Said
 */

/** @param {Said} sentence @returns {string} in the reader's language */
export function told(sentence) {
  if (typeof sentence === "string") return catalogue[sentence] ?? sentence;
  const values = Object.entries(sentence.values).map(([name, value]) => [name, told(value)]);
  return filled(catalogue[sentence.code] ?? sentence.code, Object.fromEntries(values));
}

/** @param {string} template @param {Record<string, string | number>} values */
function filled(template, values) {
  return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
}
