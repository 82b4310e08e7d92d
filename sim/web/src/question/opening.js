/**
 * When a form is open. The rules come from sim/lesson/opening.py. Pure.
 *
 * @typedef {{word?: string, date?: string, done?: string, days?: number}} Rule
 * @typedef {{now: Date, words: string[], answered: boolean, handed: Record<string, string>}} State
 *   words: checksums of the words given so far; answered: the worksheet is; handed: when each form was
 */

import { tr } from "../../../view/language.js";

const NAMES = /** @type {Record<string, string>} */ ({
  pre: tr("the test before the lesson"),
  post: tr("the test after the lesson"),
  delayed: tr("the last test"),
});

/** Why a form is not open yet; empty: it is. @param {Rule} rule @param {State} state @returns {string[]} */
export function reasons(rule, state) {
  const why = [];
  if (rule.word && !state.words.includes(rule.word)) {
    why.push(tr("It opens with your teacher's word."));
  }
  if (rule.date && today(state.now) < rule.date) {
    why.push(tr("It opens on {date}.", { date: rule.date }));
  }
  if (rule.done === "worksheet" && !state.answered) {
    why.push(tr("It opens when every question of the worksheet above is answered."));
  } else if (rule.done && rule.done !== "worksheet") {
    const handed = state.handed[rule.done];
    if (!handed) {
      const form = NAMES[rule.done] ?? rule.done;
      why.push(tr("It opens when {form} is handed in.", { form }));
    } else if (rule.days) {
      const day = new Date(handed);
      day.setDate(day.getDate() + rule.days);
      if (today(state.now) < today(day)) why.push(tr("It opens on {date}.", { date: today(day) }));
    }
  }
  return why;
}

/** Whether the last day of a rule has passed. @param {Rule} rule @param {Date} now @returns {boolean} */
export function isOver(rule, now) {
  return Boolean(rule.date) && today(now) > String(rule.date);
}

/** The checksum under which the page knows a word. @param {string} scope id of the form @param {string} word @returns {string} */
export function wordSum(scope, word) {
  const text = `${scope}:${word.replace(/\s+/g, "").toUpperCase()}`;
  let crc = ~0;
  for (const byte of new TextEncoder().encode(text)) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return (~crc >>> 0).toString(16).padStart(8, "0");
}

/** The date on this computer's calendar. @param {Date} date @returns {string} 2027-03-01 */
function today(date) {
  const two = (/** @type {number} */ n) => String(n).padStart(2, "0");
  return `${date.getFullYear()}-${two(date.getMonth() + 1)}-${two(date.getDate())}`;
}
