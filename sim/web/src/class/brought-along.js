/** What sim/pages/classroom/practice_keys.py gives to the page: the keys of what can be practised. */

const STRING = /"(?:[^"\\]|\\.)*"/g; // of JSON

/**
 * The texts of the key files. That of a translation comes as the place of its lesson's, and what its
 * strings are instead: 0 where they are the same.
 * @param {(string | [number, ...(string | 0)[]])[]} given
 * @returns {string[]}
 */
export const inFull = (given) =>
  given.map((key) => {
    if (typeof key === "string") return key;
    let n = 0;
    return /** @type {string} */ (given[key[0]]).replace(STRING, (same) => {
      const own = key[++n];
      return typeof own === "string" ? JSON.stringify(own) : same;
    });
  });
