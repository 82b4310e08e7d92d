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

/** @typedef {{key: string, pattern: RegExp, words: number}} Form words: of its own */

/** @type {Form[] | null} sentences that come from Python, those with most text of their own first */
let forms = null;
/** One with fewer words, “{first} and {last}”, is only a part: alone it fits what authors write. */
const ENOUGH = 2;

/**
 * A sentence that Python made, in English: told in the reader's language where the catalogue has a
 * sentence of its form. What stands at its {names} is told the same way. Twin of
 * `sim/pages/language/say.py`.
 * @param {string} english @returns {string}
 */
export function heard(english) {
  forms ??= Object.keys(catalogue)
    .filter((key) => PLACE.test(key))
    .sort((a, b) => own(b).length - own(a).length)
    .map((key) => ({ key, pattern: pattern(key), words: own(key).trim().split(/\s+/).length }));
  const whole = forms.filter(({ words }) => words >= ENOUGH);
  return toldAs(english, whole, forms);
}

/** @param {string} english @param {Form[]} some @param {Form[]} all that its parts may have @returns {string} */
function toldAs(english, some, all) {
  if (catalogue[english]) return catalogue[english];
  for (const { key, pattern: form } of some) {
    const found = form.exec(english);
    if (!found) continue;
    const parts = Object.entries(found.groups ?? {});
    const told = parts.map(([name, part]) => [name, toldAs(part, all, all)]);
    return tr(key, Object.fromEntries(told));
  }
  return english;
}

const PLACE = /\{\w+\}/;

/** @param {string} key */
const own = (key) => key.replace(/\{\w+\}/g, "");

/** @param {string} key @returns {RegExp} what a sentence of this form looks like */
function pattern(key) {
  const named = new Set();
  const parts = key.split(/\{(\w+)\}/).map((part, k) => {
    if (k % 2 === 0) return part.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
    if (named.has(part)) return `\\k<${part}>`; // the same again
    named.add(part);
    return `(?<${part}>.+?)`;
  });
  return new RegExp(`^${parts.join("")}$`, "su");
}
