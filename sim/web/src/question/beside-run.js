/**
 * What stood in a question when the run beside it was watched, and at which press on Check it was
 * right: a teacher sees by it who thought again. Entries in, entries out.
 */

import { isEmpty } from "../answers/entry.js";

/** The scene whose run a question is about: it waits for it, or both stand in one section. @param {HTMLElement} question @returns {Element | null} */
function sceneBeside(question) {
  const { after } = question.dataset;
  if (after) return document.getElementById(after);
  /** @type {Element | null} */
  let above = null;
  for (const part of document.querySelectorAll("h2, carts-scene")) {
    const below = question.compareDocumentPosition(part) & Node.DOCUMENT_POSITION_FOLLOWING;
    if (below && above) break;
    if (part.localName === "h2") {
      if (below) break;
      above = null;
    } else if (below) return part;
    else above = part;
  }
  return above;
}

/** Calls when the run beside a question was watched. @param {HTMLElement} question @param {() => void} act @param {AbortSignal} signal */
export function whenWatched(question, act, signal) {
  const watched = (/** @type {Event} */ { target }) => {
    if (target === sceneBeside(question)) act();
  };
  document.addEventListener("carts-watched", watched, { signal });
}

/** The entry with the answer as it stood at the run, told once. @param {any} entry */
export function atTheRun(entry) {
  const { value, said } = entry;
  return "before" in entry || isEmpty(value) ? entry : { ...entry, before: { value, said } };
}

/** The same of one that changes: who answers first after the run had nothing before it. @param {HTMLElement} question @param {any} entry */
export function changing(question, entry) {
  const watched = sceneBeside(question)?.hasAttribute("data-watched") ?? false;
  return watched && !("before" in entry) ? { ...entry, before: null } : entry;
}

/** The entry after a press on Check: once more as it was, it is no other try. @param {any} entry */
export function tried(entry) {
  return entry.judged ? entry : { ...entry, tries: (entry.tries ?? 0) + 1, judged: true };
}

/** The entry with the press on Check at which it was right first; 0: none yet. @param {any} entry @param {string} verdict */
export function checked(entry, verdict) {
  const right = entry.right || (verdict === "right" ? entry.tries : 0);
  return right === entry.right ? entry : { ...entry, right };
}
