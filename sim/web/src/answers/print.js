/** The page on paper: with the answers, or empty, to be filled in by hand. */

import { tr } from "../../../view/language.js";
import { say } from "../shared/dom.js";
import { printWith } from "../shared/printing.js";

/** @param {boolean} empty without the answers, and without what the lesson marks as for who has time */
export function print(empty) {
  const { classList } = document.documentElement;
  classList.toggle("carts-print-empty", empty);
  const back = empty ? blanked() : [];
  for (const dialog of document.querySelectorAll("dialog")) dialog.close();
  printWith(() => {
    classList.remove("carts-print-empty");
    for (const undo of back) undo();
  });
}

/** Empties what styles cannot: code word, predictions, and runs that were watched. @returns {(() => void)[]} what brings them back */
function blanked() {
  const scenes = [...document.querySelectorAll("carts-scene")].map(blank);
  const head = document.querySelector(".carts-print-head");
  if (!head) return scenes;
  const text = head.textContent;
  say(head, tr("Code word: {code}", { code: "____________________" }));
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
