/** What teacher mode asks of Python once, on a press of a button. */

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
 * @param {Client} client @param {string} text @param {string} own @returns {Promise<{text: string, missing: number}>}
 */
export async function restored(client, text, own) {
  const { header } = await client.ask({}, () => ({ kind: "teach", do: "restore", text, own }));
  return /** @type {any} */ (header);
}
