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
  const said = catalogue[sentence] ?? sentence;
  return said.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
}

/** @typedef {{key: string, pattern: RegExp, own: string}} Form own: text */

/** @type {Form[] | null} sentences that come from Python, those with most text of their own first */
let forms = null;
/** A form with fewer words is only a part of others: alone it fits what authors write. */
const ENOUGH = 2;

/**
 * A sentence that Python made, in English: told in the reader's language where the catalogue has a
 * sentence of its form. What stands at its {names} is told the same way, and may be a list. Twin of
 * `sim/pages/language/say.py`.
 * @param {string} english @returns {string}
 */
export function heard(english) {
  forms ??= Object.keys(catalogue)
    .filter((key) => PLACE.test(key))
    .map((key) => ({ key, pattern: pattern(key), own: key.replace(/\{\w+\}/g, "") }))
    .sort((a, b) => b.own.length - a.own.length || (a.key < b.key ? -1 : 1));
  return catalogue[english] ?? (filled(english, large(forms)) || english);
}

/** What stands at a name: a sentence of its own, a list, or a small form. @param {string} english @returns {string} */
function part(english) {
  const said = catalogue[english] ?? filled(english, large(forms ?? []));
  if (said) return said;
  const listed = english.split(", ");
  if (listed.length > 1) return listed.map(part).join(", ");
  return filled(english, forms ?? []) || english;
}

/** @param {Form[]} some */
const large = (some) => some.filter(({ own }) => own.split(/\s+/).filter(Boolean).length >= ENOUGH);

/** @param {string} english @param {Form[]} some that are tried @returns {string} empty: none fits */
function filled(english, some) {
  for (const { key, pattern: form } of some) {
    const found = form.exec(english);
    if (!found) continue;
    const parts = Object.entries(found.groups ?? {}).map(([name, said]) => [name, part(said)]);
    return tr(key, Object.fromEntries(parts));
  }
  return "";
}

const PLACE = /\{\w+\}/;

/** @param {string} key @returns {RegExp} what a sentence of this form looks like; {a}, one letter, holds one word */
function pattern(key) {
  const named = new Set();
  const parts = key.split(/\{(\w+)\}/).map((piece, k) => {
    if (k % 2 === 0) return piece.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
    if (named.has(piece)) return `\\k<${piece}>`; // the same again
    named.add(piece);
    return `(?<${piece}>${piece.length === 1 ? "[^\\s,]+" : ".+?"})`;
  });
  return new RegExp(`^${parts.join("")}$`, "su");
}
