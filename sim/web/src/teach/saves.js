/** The toolbar: undo, save, save as a zip, back to the published lesson. */

import { askingButton, button } from "../answers/parts.js";
import { html, need } from "../shared/dom.js";
import { download, downloadBlob } from "../shared/download.js";
import { passOn } from "../shared/working.js";

const WITHHELD =
  "Notes and marking guides are not in it: before it takes the place of your own file, choose that file in the yellow box and save again.";

/** @param {import("./session.js").Session} session @param {(text: string, kind?: import("./types.js").Kind) => void} tell */
export function toolbar(session, tell) {
  const root = html("div", "carts-teach-tools");
  const undo = button("Undo", () => session.undo(), "carts-teach-undo");
  const redo = button("Redo", () => session.redo(), "carts-teach-redo");
  /** @param {string} name @param {string} words @param {string[]} lacking what is told of values that are not in it */
  const saved = (name, words, lacking) => {
    const faulty = Boolean(session.look?.findings.length);
    const said = [
      lacking.length ? `${name} was made without what you typed last. ${lacking.join(" ")}` : words,
    ];
    if (session.withheld) said.push(WITHHELD);
    if (faulty) said.push("There are mistakes in it: the build would stop at them.");
    tell(said.join(" "), faulty ? "fault" : said.length > 1 || lacking.length ? "warning" : "");
  };
  const save = button(
    "Save lesson",
    async () => {
      const lacking = await session.typed();
      const { name } = session;
      download(name, session.text, "text/markdown");
      saved(name, `Saved as ${name}: look in your folder “Downloads”.`, lacking);
    },
    "carts-teach-save",
  );
  const zip = button(
    "Save as zip",
    async () => {
      const name = session.name.replace(/\.md$/, ".zip");
      const lacking = await session.typed();
      try {
        const bytes = Uint8Array.from(atob(await session.zip()), (letter) => letter.charCodeAt(0));
        downloadBlob(name, new Blob([bytes], { type: "application/zip" }));
        saved(name, `Saved as ${name}, with a list of what was changed.`, lacking);
      } catch (error) {
        tell(/** @type {Error} */ (error).message);
      }
    },
    "carts-teach-zip",
  );
  const reset = askingButton(
    "Back to the published lesson",
    "Go back to the lesson as it was published?",
    "Yes, go back",
    () => session.reset(),
    "carts-teach-reset",
  );
  root.append(undo, redo, save, zip, reset);
  const back = /** @type {HTMLButtonElement} */ (need(reset, "button"));
  const draw = () => {
    undo.disabled = !session.history.canUndo;
    redo.disabled = !session.history.canRedo;
    if (!session.changed) passOn(back, undo); // which brings back what was there
    back.disabled = !session.changed;
  };
  draw();
  return { root, draw };
}
