/** What can be done with a report: print it, save it, delete everything. */

import { tr } from "../../../view/language.js";
import { askingButton, button } from "../answers/parts.js";
import { html } from "../shared/dom.js";
import { download, downloadBlob } from "../shared/download.js";
import { plotsAsPng } from "./plots.js";

/** @typedef {{classroom: import("./classroom.js").Classroom}} Owner */

/**
 * @param {{element: Owner, report: HTMLElement, ask: (what: string) => Promise<Record<string, any>>,
 *   say: (text: string) => void, clear: () => void}} given
 */
export function actions({ element, report, ask, say, clear }) {
  const root = html("div", "carts-class-actions");
  /** @param {string} what @param {string} name @param {string} type */
  const save = (what, name, type) => async () => {
    try {
      const { text } = await ask(what);
      download(name, text, type);
      say(tr("Saved as {name}: look in your folder “Downloads”.", { name }));
    } catch (error) {
      say(/** @type {Error} */ (error).message);
    }
  };
  const marks = button(
    tr("Save marks"),
    () => {
      download("class.marks.json", element.classroom.marksFile(), "application/json");
      element.classroom.unfiled = false;
      say(
        tr("Saved as {name}. Drop it here with the files next time.", { name: "class.marks.json" }),
      );
    },
    "carts-class-save-marks",
  );
  const row = html("p", "carts-class-row");
  row.append(
    button(tr("Print this report"), () => window.print(), "carts-class-print"),
    " ",
    button(
      tr("Save report"),
      save("html", "class-results.html", "text/html"),
      "carts-class-save-html",
    ),
    " ",
    button(
      tr("Students (CSV)"),
      save("csv", "class-students.csv", "text/csv"),
      "carts-class-save-csv",
    ),
    " ",
    button(
      tr("Questions (CSV)"),
      save("items", "class-questions.csv", "text/csv"),
      "carts-class-save-items",
    ),
    " ",
    button(
      tr("Plots (PNG)"),
      async () => {
        const picture = await plotsAsPng(report);
        if (!picture) return say(tr("There is no plot yet: it takes five students and a key."));
        downloadBlob("class-plots.png", picture);
        return say(tr("Saved as {name}.", { name: "class-plots.png" }));
      },
      "carts-class-save-png",
    ),
    " ",
    marks,
  );
  const remove = askingButton(
    tr("Delete everything"),
    tr("Forget all files, codes and marks on this page?"),
    tr("Delete"),
    clear,
    "carts-class-clear",
    tr("Keep them"),
  );
  root.append(row, remove);
  const draw = () => {
    root.hidden = element.classroom.empty;
    marks.hidden = !element.classroom.marks.size;
  };
  return { root, draw };
}
