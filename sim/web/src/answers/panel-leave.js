/** Leaving a shared laptop: clear one's own answers, or everything; and where answers are kept. */

import { tr } from "../../../view/language.js";
import { html, say } from "../shared/dom.js";
import { forgetTab, retain } from "../shared/tab.js";
import { CAME } from "./bar.js";
import { askingButton, part, status } from "./parts.js";

/** @param {import("./book.js").Book} book @returns {HTMLElement} */
export function leavePart(book) {
  const root = part("leave", tr("Before you leave this computer"));
  const told = status();
  const forget = async (/** @type {boolean} */ everybody) => {
    try {
      await book.forget(everybody);
    } catch {
      return say(
        told,
        tr(
          "This browser refuses to delete: answers are still on this computer. Try again, or clear the browser's data.",
        ),
      );
    }
    forgetTab();
    retain(CAME, "");
    location.reload();
  };
  root.append(
    html("p", "carts-answers-where", whereKept(book)),
    askingButton(
      tr("Clear my answers here"),
      tr("Is your file saved? Your answers on this computer will be gone."),
      tr("Clear my answers"),
      () => void forget(false),
      "carts-answers-clear",
      tr("Keep them"),
    ),
    askingButton(
      tr("Delete everything"),
      tr("This deletes the answers of everybody who worked on this computer."),
      tr("Delete all of them"),
      () => void forget(true),
      "carts-answers-delete",
      tr("Keep them"),
    ),
    told,
  );
  return root;
}

/** What this browser does with answers. @param {import("./book.js").Book} book */
function whereKept(book) {
  if (!book.lasts)
    return tr("This browser keeps nothing after the page is closed. Save your file now.");
  const words = [tr("Your answers are kept in this browser on this computer, and nowhere else.")];
  if (book.store?.how === "text")
    words.push(tr("If the computer crashes, the last seconds may be lost."));
  if (location.protocol === "file:" && navigator.userAgent.includes("Firefox/")) {
    words.push(
      tr(
        "Firefox keeps them for this page in this folder: if the folder is moved or renamed, bring your file back in.",
      ),
    );
  } else if (location.protocol === "file:") {
    words.push(tr("They are still there if the folder is moved or renamed."));
  }
  words.push(
    tr(
      "A private window, or a laptop that is wiped when you log out, may forget them: save your file before you leave.",
    ),
  );
  return words.join(" ");
}
