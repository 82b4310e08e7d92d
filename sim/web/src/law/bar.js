/** The buttons of a law: run it, have it judged, stop, save it, begin again. */

import { tr } from "../../../view/language.js";
import { askingButton } from "../answers/parts.js";
import { html } from "../shared/dom.js";
import { passOn } from "../shared/working.js";

/** @param {Record<"run" | "judge" | "stop" | "save" | "again", () => void>} acts */
export function lawBar(acts) {
  const button = (/** @type {string} */ text, /** @type {() => void} */ act, name = "") => {
    const made = /** @type {HTMLButtonElement} */ (html("button", `carts-button ${name}`, text));
    made.type = "button";
    made.addEventListener("click", act);
    return made;
  };
  const root = html("div", "carts-law-bar");
  const run = button(tr("Run"), acts.run, "carts-law-act");
  const judge = button(tr("Judge"), acts.judge, "carts-law-act");
  const end = button(tr("Stop"), acts.stop);
  end.disabled = true;
  const again = askingButton(
    tr("Begin again"),
    tr("Back to the law that you began with? Yours stays in “My answers”."),
    tr("Begin again"),
    acts.again,
    "carts-law-again",
  );
  root.append(run, judge, end, button(tr("Save as a file"), acts.save), again);
  let begun = run; // the one that was pressed
  /** @param {boolean} on whether one of them is at work */
  const working = (on) => {
    if (on) begun = document.activeElement === judge ? judge : run;
    for (const one of on ? [end] : [run, judge]) one.disabled = false;
    passOn(on ? begun : end, on ? end : begun);
    for (const one of on ? [run, judge] : [end]) one.disabled = true;
  };
  return { root, end, working };
}
