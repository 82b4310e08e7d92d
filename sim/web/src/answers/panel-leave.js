/** Leaving a shared laptop: clear one's own answers, or everything; and where answers are kept. */

import { html } from "../dom.js";
import { askingButton, part } from "./parts.js";

/** @param {import("./book.js").Book} book @returns {HTMLElement} */
export function leavePart(book) {
  const root = part("leave", "Before you leave this computer");
  const forget = async (/** @type {boolean} */ everybody) => {
    await book.forget(everybody);
    location.reload();
  };
  root.append(
    html("p", "carts-answers-where", whereKept(book)),
    askingButton(
      "Clear this laptop",
      "Is your file saved? Your answers on this computer will be gone.",
      "Clear my answers",
      () => void forget(false),
      "carts-answers-clear",
    ),
    askingButton(
      "Delete everything",
      "This deletes the answers of everybody who worked on this computer.",
      "Delete all of them",
      () => void forget(true),
      "carts-answers-delete",
    ),
  );
  return root;
}

/** What this browser does with answers. @param {import("./book.js").Book} book */
function whereKept(book) {
  const how = book.store?.how;
  if (how === "memory")
    return "This browser keeps nothing after the page is closed. Save your file now.";
  const words = ["Your answers are kept in this browser on this computer, and nowhere else."];
  if (how === "text") words.push("If the computer crashes, the last seconds may be lost.");
  if (location.protocol === "file:" && navigator.userAgent.includes("Firefox/")) {
    words.push(
      "Firefox keeps them for this page in this folder: if the folder is moved or renamed, bring your file back in.",
    );
  } else if (location.protocol === "file:") {
    words.push("They are still there if the folder is moved or renamed.");
  }
  words.push(
    "A private window, or a laptop that is wiped when you log out, may forget them: save your file before you leave.",
  );
  return words.join(" ");
}
