/**
 * A question that opens when its scene was watched: the text of a question often tells what was seen.
 * It opens too where no run can be had (Python cannot start), for who answered it before, and by the
 * teacher's key in “My answers”.
 */

const OPEN_ALL = "carts-open-questions";

/** @param {HTMLElement} question @param {boolean} answered before */
export function wait(question, answered) {
  const id = question.dataset.after;
  if (!id || question.dataset.opened !== undefined) return;
  const open = () => (question.dataset.opened = "");
  const scene = document.getElementById(id);
  const shown = () => !scene || ["watched", "reason"].some((name) => name in scene.dataset);
  if (answered || shown()) return open();
  for (const kind of ["carts-watched", "carts-error"]) {
    document.addEventListener(kind, () => shown() && open());
  }
  document.addEventListener(OPEN_ALL, open);
}

/** Whether any question of this page still waits. */
export function anyWaits() {
  return document.querySelector("carts-question[data-after]:not([data-opened])") !== null;
}

/** The teacher's key: all questions of this page. */
export function openAll() {
  document.dispatchEvent(new Event(OPEN_ALL));
}
