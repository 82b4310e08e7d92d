/**
 * The teacher's key: opens all that waits on this page. Folded away from students, who would lose what there
 * is to find; where the site has a teacher's word, it asks for it.
 */

import { tr } from "../../../view/language.js";
import { anyWaits, openAll } from "../question/gate.js";
import { wordSum } from "../question/opening.js";
import { html, say } from "../shared/dom.js";
import { recall, retain } from "../shared/tab.js";
import { KEY, teachersWord } from "../teach/door.js";
import { askingButton, fault, status } from "./parts.js";

/** @returns {HTMLElement | ""} nothing where nothing waits */
export function teachersPart() {
  if (!anyWaits()) return "";
  const root = html("details", "carts-answers-part carts-answers-teachers");
  const told = status();
  const sum = wanted();
  const box = document.createElement("input");
  Object.assign(box, { type: "text", autocomplete: "off", maxLength: 60, spellcheck: false });
  const label = html("label", "", `${tr("Your teacher's word")} `);
  label.append(box);
  const key = askingButton(
    tr("Open all questions"),
    tr(
      "All questions and texts of this page that wait for a run open at once, and tell what it shows. Open them?",
    ),
    tr("Open them now"),
    () => {
      if (sum && wordSum("teacher", box.value) !== sum) {
        return fault(told, tr("That is not the word."));
      }
      if (sum) retain(KEY, sum);
      openAll();
      label.remove();
      key.remove();
      return say(told, tr("All questions of this page are open now."));
    },
    "carts-answers-open-all",
  );
  root.addEventListener("toggle", () => root.scrollIntoView({ block: "nearest" })); // it is the last
  root.append(html("summary", "", tr("For teachers")), ...(sum ? [label] : []), key, told);
  return root;
}

/** The checksum of the teacher's word, where the site has one that was not given in this tab. */
function wanted() {
  const sum = teachersWord();
  return recall(KEY) === sum ? "" : sum;
}
