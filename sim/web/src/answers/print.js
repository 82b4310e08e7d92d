/** The page on paper: with the answers, or empty, to be filled in by hand. */

import { tr } from "../../../view/language.js";
import { say } from "../shared/dom.js";
import { printWith } from "../shared/printing.js";
import { outline } from "./outline.js";

const EMPTY = "carts-print-empty"; // the class of a page that is printed so
const ALL = "carts-print-all"; // with the questions that wait for a run: their text may tell what it shows
let chosen = false; // in “My answers”, how it is printed

/** @param {boolean} empty without the answers, and without what the lesson marks as for who has time */
export function print(empty) {
  chosen = true;
  const undo = empty ? emptied([EMPTY, ALL]) : () => {};
  for (const dialog of document.querySelectorAll("dialog")) dialog.close();
  printWith(() => {
    chosen = false;
    undo();
  });
}

/**
 * A lesson that nobody has worked in is an empty sheet by the browser's own way to print, too; it says how
 * all questions are printed.
 * @param {import("./book.js").Book} book
 */
export function emptyWhereUntouched(book) {
  addEventListener("beforeprint", () => {
    const answered = book.entries().some(([key]) => key.startsWith(`${book.page}#`));
    const worked = answered || document.querySelector("[data-watched], [data-printing]");
    if (chosen || worked || !outline()) return;
    const how = tr("To print the questions that wait, too: “My answers”, “Print empty”.");
    addEventListener("afterprint", emptied([EMPTY], `${how} `), { once: true });
  });
}

/** @param {string[]} names of the page @param {string} how said above all @returns {() => void} what makes the page whole again */
function emptied(names, how = "") {
  const { classList } = document.documentElement;
  classList.add(...names);
  const back = blanked(how);
  return () => {
    classList.remove(...names);
    for (const undo of back) undo();
  };
}

/** Empties what styles cannot: code word, predictions, and runs that were watched. @param {string} how @returns {(() => void)[]} what brings them back */
function blanked(how) {
  const scenes = [...document.querySelectorAll("carts-scene")].map(blank);
  const head = document.querySelector(".carts-print-head");
  if (!head) return scenes;
  const text = head.textContent;
  say(head, how + tr("Code word: {code}", { code: "____________________" }));
  return [...scenes, () => say(head, text)];
}

/**
 * Puts the scene as the lesson was built beside it, for this print alone: its start, and the question.
 * @param {Element} scene @returns {() => void}
 */
function blank(scene) {
  const { asBaked } = /** @type {any} */ (scene);
  const untouched = scene.matches(".carts-asks:not(:has(.carts-saved:not(:empty)))");
  if (!asBaked || untouched) return () => {};
  const sheet = document.createElement("carts-blank");
  sheet.className = `${scene.className} carts-asks`;
  sheet.innerHTML = asBaked;
  scene.after(sheet);
  return () => sheet.remove();
}
