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
 * HTML as a template: html`<p title=${title}>${text}</p>`. The value of an attribute gets its quotes
 * here. Lists stand one after another; nothing stands for false, null and undefined.
 * @param {TemplateStringsArray} strings @param {(Part | Part[])[]} values @returns {Markup}
 */
export function html(strings, ...values) {
  let written = strings[0] ?? "";
  values.forEach((value, k) => {
    const quote = strings[k]?.endsWith("=") ? '"' : "";
    written += quote + asText(value) + quote + (strings[k + 1] ?? "");
  });
  return new Markup(written);
}

/** @param {Part | Part[]} value @returns {string} */
function asText(value) {
  if (Array.isArray(value)) return value.map(asText).join("");
  if (value instanceof Markup) return value.text;
  if (value === false || value === null || value === undefined) return "";
  return String(value).replace(/[&<>"']/g, (sign) => ESCAPED[sign] ?? sign);
}
