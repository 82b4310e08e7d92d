/** A box into which a number is typed, a decimal comma too; what is none is told beside it. */

import { tr } from "../../../view/language.js";
import { html, say } from "./dom.js";
import { noNumber, readTyped } from "./typed.js";

/** @param {HTMLInputElement} box @returns {number | null} null: nothing stands there, or no number */
export function numberIn({ value }) {
  const read = readTyped(value);
  return "value" in read ? read.value : null;
}

/** Why no number stands in a box; empty: one does. @param {HTMLInputElement} box @returns {string} */
export function problemIn({ value }) {
  const read = readTyped(value);
  if ("text" in read) return noNumber(read.text);
  return "problem" in read ? read.problem : "";
}

/** The same of a box that may stay empty. @param {HTMLInputElement} box */
export const ifTyped = (box) => (box.value.trim() ? problemIn(box) : "");

/** The same where only what is above 0 makes sense. @param {HTMLInputElement} box @param {string} problem */
export function unlessPositive(box, problem) {
  return Number(numberIn(box) ?? 1) <= 0 ? tr("A number above 0, please.") : problem;
}

/** The same, told beside it. @param {HTMLInputElement} box @param {string} problem */
export function complainUnlessPositive(box, problem) {
  complain(box, unlessPositive(box, problem));
}

/** @param {HTMLInputElement} box @param {string} problem told beside it; empty: none */
export function complain(box, problem) {
  const place = box.closest("label, [data-hand]") ?? /** @type {HTMLElement} */ (box.parentElement);
  const told = place.querySelector(".carts-error") ?? html("span", "carts-error");
  if (!problem) return told.remove();
  told.setAttribute("role", "alert");
  place.append(told);
  say(told, problem);
}
