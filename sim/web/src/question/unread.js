/** What a question says of an answer that it cannot read: a number with two commas, a unit that it does not know. */

import { need, say } from "../shared/dom.js";

const PAUSE = 1500; // ms after the last key: a number that is still being typed is not wrong yet

/** @type {WeakMap<HTMLElement, number>} */
const waiting = new WeakMap();

/** @param {HTMLElement} question @param {string} problem nothing: there is none */
export function complain(question, problem) {
  clearTimeout(waiting.get(question));
  const place = need(question, ".carts-q-error");
  say(place, problem);
  place.hidden = !problem;
}

/** For a form without *Check*: nobody would be told that what is handed in is no number. @param {HTMLElement & {unread: string}} question */
export function complainSoon(question) {
  complain(question, "");
  const timer = window.setTimeout(() => complain(question, question.unread), PAUSE);
  waiting.set(question, timer);
}
