/** What a scene tells of itself. */

import { told, tr } from "../../../view/language.js";
import { need, say } from "../shared/dom.js";

export const ASK_FIRST = tr("Make your prediction and lock it first.");
export const LIVE = tr("live: Python computes in this page");
export const NOT_STARTED = tr("Python could not start.");
const STILL_PLAYS = tr("The prepared run still plays; values cannot be changed.");
const NOT_SHOWN = tr("Your prediction is kept; the run cannot be shown.");
const STEPWISE = tr("The scene still works: its sliders go from one prepared run to the next.");
const SLOW = {
  slow: tr("This computer needs long to start Python. It is still trying."),
  "slow-line": tr(
    "The network is slow: Python is still on its way. You need not load the page again.",
  ),
};
export const LONG_RUN = tr("This computer needs long for this run. It is still computing.");
export const PREDICTION_KEPT = tr("Your prediction is kept.");

/** What is said while a start takes long. @param {keyof typeof SLOW} what @param {boolean} stepwise there are sliders, and prepared runs for them */
export const slow = (what, stepwise) => (stepwise ? `${SLOW[what]} ${STEPWISE}` : SLOW[what]);

/** What still works where Python does not. @param {boolean} told no prediction is waited for @param {boolean} stepwise there are prepared runs */
export function without(told, stepwise) {
  if (stepwise) return STEPWISE;
  return told ? STILL_PLAYS : NOT_SHOWN;
}

/** Says something above the picture. @param {HTMLElement} scene @param {string} message for the reader; empty: none */
export function note(scene, message) {
  const place = need(scene, ".carts-note");
  place.hidden = !message;
  place.classList.remove("carts-passing");
  say(place, message);
}

/** Something that is true for a while: nothing makes room for it. @param {HTMLElement} scene @param {string} message @param {boolean} on */
export function passing(scene, message, on) {
  const place = need(scene, ".carts-note");
  if (!on && place.textContent !== message) return; // another message stands there since
  note(scene, on ? message : "");
  place.classList.toggle("carts-passing", on);
  if (on) place.style.top = `${need(scene, ".carts-top").offsetHeight}px`; // below the title, over the sky
}

/** The same, behind why Python does not run where that is said already. @param {HTMLElement} scene @param {string} message */
export function noteBeside(scene, message) {
  const why = scene.dataset.state === "failed" ? need(scene, ".carts-note").dataset.why : "";
  note(scene, `${why ?? ""} ${message}`.trim());
}

/** How a run was solved, phase by phase. @param {import("../../../view/types.js").Run | undefined} run */
export function planOf(run) {
  return (run?.header.plan ?? []).map((phase) => ({ ...phase, why: told(phase.why) }));
}

/** @param {HTMLElement} scene @param {boolean} on */
export function offerUndo(scene, on) {
  const undo = scene.querySelector(".carts-undo");
  if (undo instanceof HTMLButtonElement) undo.disabled = !on;
}
