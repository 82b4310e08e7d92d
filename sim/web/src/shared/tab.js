/**
 * What a page remembers: for as long as its tab is open, or for as long as this browser keeps it. A browser
 * that keeps nothing forgets it: no fault.
 */

/** @typedef {() => Storage} Where asked for when it is needed: a browser may refuse it */

/** @type {Where} */
const TAB = () => sessionStorage;
const OURS = "carts";
/** @type {Where} */
export const BROWSER = () => localStorage;

/** @param {string} key @param {Where} where @returns {any} what was kept; null: nothing */
export function recall(key, where = TAB) {
  try {
    return JSON.parse(where().getItem(key) ?? "null");
  } catch {
    return null;
  }
}

/** What was kept once, and is not kept any more. @param {string} key @param {Where} where @returns {any} */
export function recallOnce(key, where = TAB) {
  const kept = recall(key, where);
  try {
    where().removeItem(key);
  } catch {
    // as above
  }
  return kept;
}

/** Somebody else works in this tab from now on: what the one before has watched and tried is gone. */
export function forgetTab() {
  try {
    for (const key of Object.keys(TAB())) if (key.startsWith(OURS)) TAB().removeItem(key);
  } catch {
    // as above
  }
}

/** @param {string} key @param {unknown} value @param {Where} where */
export function retain(key, value, where = TAB) {
  try {
    where().setItem(key, JSON.stringify(value));
  } catch {
    // as above
  }
}
