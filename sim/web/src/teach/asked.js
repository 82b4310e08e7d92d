/** What teacher mode asks of Python once, on a press of a button or for one value. */

/** @typedef {import("../runtime/client.js").Client} Client */

/** A zip of what was changed, in base64. @param {Client} client @param {string} file @param {string} text @param {string} published the text as it was published */
export async function zipped(client, file, text, published) {
  const { header } = await client.ask({}, () => ({
    kind: "teach",
    do: "zip",
    file,
    text,
    published,
  }));
  return /** @type {string} */ (/** @type {any} */ (header).base64);
}

/**
 * The text with what was kept out of the site, from the teacher's own file, and how much is missing there.
 * @param {Client} client @param {() => string} text as it is @param {string} own @returns {Promise<{text: string, missing: number}>}
 */
export function restored(client, text, own) {
  return ofText(client, {}, text, { do: "restore", own });
}

/**
 * The text with one value of a block, or why it is refused.
 * @param {Client} client @param {object} owner @param {() => string} text as it is
 * @param {{block: number, path: (string | number)[], value: string}} one @returns {Promise<{text: string, refused?: string}>}
 */
export function written(client, owner, text, one) {
  return ofText(client, owner, text, { do: "set", ...one });
}

/**
 * Asks until the answer is about the text as it still is: other changes made meanwhile would be lost under it.
 * @param {Client} client @param {object} owner @param {() => string} text @param {Record<string, unknown>} asked @returns {Promise<any>}
 */
async function ofText(client, owner, text, asked) {
  for (;;) {
    const { header, sent } = await client.ask(owner, () => ({
      kind: "teach",
      ...asked,
      text: text(),
    }));
    if (/** @type {any} */ (header).refused || sent.text === text()) return header;
  }
}
