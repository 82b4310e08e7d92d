/**
 * Values that a reader has set, as a text: the same in whatever order they were set.
 * @param {Record<string, unknown>} settings @returns {string}
 */
export const asText = (settings) => JSON.stringify(Object.entries(settings).sort());
