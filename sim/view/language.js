/**
 * The reader's language. An English sentence is its own key; a page in another language brings a
 * catalogue along (`sim/pages/language`). Without one, or without that sentence, English stands.
 */

/** @type {Record<string, string>} */
const catalogue = /** @type {any} */ (globalThis).cartsWords ?? {};
const FORMS = "\0"; // between the forms of a counted sentence; see `sim/scene/said.py`
const RULE = catalogue["\0"] ?? ""; // for each number from 0 to 199 the digit of its form

/**
 * A sentence in the reader's language. It must stand here as text, so that it is found for the
 * catalogues; what changes in it stands as {name}.
 * @param {string} sentence @param {Record<string, string | number>} values @returns {string}
 */
export function tr(sentence, values = {}) {
  return filled(catalogue[sentence] ?? sentence, values);
}

/**
 * A sentence for `n` of something, in the form that its number has in the reader's language.
 * @param {string} one @param {string} more @param {number} n
 * @param {Record<string, string | number>} values @returns {string}
 */
export function counted(one, more, n, values = {}) {
  return filled(form(one, more, n), { n, ...values });
}

/** @param {string} one @param {string} more @param {number} n @returns {string} its template */
function form(one, more, n) {
  const ours = catalogue[more]?.split(FORMS);
  if (!ours) return n === 1 ? one : more;
  const english = n === 1 ? 0 : 1;
  const asked = RULE ? Number(RULE[n < RULE.length ? n : 100 + (n % 100)]) : english;
  return String(ours[Math.min(asked, ours.length - 1)]);
}

/**
 * A sentence as Python sends it: its template, which is its key in the catalogues, and the values in it,
 * which may be such sentences themselves; `one` where it counts. A word alone is its own key.
 * @typedef {string | {code: string, values: Record<string, Said>, one?: string}} Said
 */

/** @param {Said} sentence @returns {string} in the reader's language */
export function told(sentence) {
  if (typeof sentence === "string") return catalogue[sentence] ?? sentence;
  const values = Object.entries(sentence.values).map(([name, value]) => [name, told(value)]);
  const { code, one } = sentence;
  const n = Number(String(sentence.values.n).replace(/,/g, ""));
  const template = one ? form(one, code, n) : (catalogue[code] ?? code);
  return filled(template, Object.fromEntries(values));
}

/** @param {string[]} parts @returns {string} one after the other, with the comma of the reader's language */
export function inRow(parts) {
  const [head = "", ...tail] = parts;
  return tail.reduce((first, second) => tr("{first}, {second}", { first, second }), head);
}

/** @param {string[]} sentences @returns {string} one after the other, as one; empty ones are left out */
export function joined(sentences) {
  const [head = "", ...tail] = sentences.filter(Boolean);
  return tail.reduce((first, then) => tr("{first} {then}", { first, then }), head);
}

/** @param {string} sentence @returns {string} with the full stop of the reader's language */
export function ended(sentence) {
  return tr("{sentence}.", { sentence });
}

/** @param {string} template @param {Record<string, string | number>} values */
function filled(template, values) {
  return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
}
