/** HTML written as text, with everything escaped that was not written as HTML itself. */

/** @type {Record<string, string>} */
const ESCAPED = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };

/** A text that is HTML already. */
export class Markup {
  /** @param {string} text */
  constructor(text) {
    this.text = text;
  }

  toString() {
    return this.text;
  }
}

/** @typedef {Markup | string | number | boolean | null | undefined} Part */

/**
 * HTML as a template: html`<p>${text}</p>`. Lists stand one after another; nothing stands for
 * false, null and undefined.
 * @param {TemplateStringsArray} strings @param {(Part | Part[])[]} values @returns {Markup}
 */
export function html(strings, ...values) {
  const written = values.map((value, k) => asText(value) + (strings[k + 1] ?? ""));
  return new Markup((strings[0] ?? "") + written.join(""));
}

/** @param {Part | Part[]} value @returns {string} */
function asText(value) {
  if (Array.isArray(value)) return value.map(asText).join("");
  if (value instanceof Markup) return value.text;
  if (value === false || value === null || value === undefined) return "";
  return String(value).replace(/[&<>"']/g, (sign) => ESCAPED[sign] ?? sign);
}

/** JSON that can stand in a script element, whatever the texts in it say. @param {unknown} value */
export function scriptJson(value) {
  return new Markup(
    JSON.stringify(value).replace(
      /[<>&\u2028\u2029]/g,
      (sign) => `\\u${sign.charCodeAt(0).toString(16).padStart(4, "0")}`,
    ),
  );
}
