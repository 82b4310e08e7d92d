/** What a page remembers for as long as its tab is open. A browser that keeps nothing forgets it: no fault. */

/** @param {string} key @returns {any} what was kept; null: nothing */
export function recall(key) {
  try {
    return JSON.parse(sessionStorage.getItem(key) ?? "null");
  } catch {
    return null;
  }
}

/** @param {string} key @param {unknown} value */
export function retain(key, value) {
  try {
    sessionStorage.setItem(key, JSON.stringify(value));
  } catch {
    // as above
  }
}
