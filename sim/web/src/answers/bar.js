/**
 * The line at the foot of the window: who works here, how much is done, whether it is kept, and the
 * button “My answers”. It floats, so that nothing of the page moves when it comes.
 */

import { tr } from "../../../view/language.js";
import { html, say, svg } from "../shared/dom.js";
import { recallOnce } from "../shared/tab.js";
import { outline } from "./outline.js";

/** What the tab remembers of who has just said who works here, empty after clearing: the page is read anew. */
export const CAME = "carts-just-came";
const GREETS = 6000; // ms

const SHEET = "M3 1.5h7l3 3v10H3zM5.5 7.5h5M5.5 10.5h3";

/** A written sheet, in place of the words where a phone has no room for them. */
function sheet() {
  const drawn = svg("svg", {
    class: "carts-bar-sheet",
    viewBox: "0 0 16 16",
    width: 18,
    height: 18,
    "aria-hidden": "true",
  });
  drawn.append(svg("path", { d: SHEET }));
  return drawn;
}

export class Bar {
  /** @param {import("./book.js").Book} book @param {() => void} openPanel */
  constructor(book, openPanel) {
    this.book = book;
    this.root = html("aside", "carts carts-bar");
    this.root.setAttribute("aria-label", tr("My answers"));
    this.who = html("button", "carts-bar-who");
    this.who.setAttribute("type", "button");
    this.who.addEventListener("click", openPanel);
    this.meter = document.createElement("progress");
    this.count = html("span", "carts-bar-count");
    this.count.title = tr("answered on this page, predictions too");
    this.meter.setAttribute("aria-label", this.count.title);
    const button = html("button", "carts-button carts-bar-open");
    button.append(sheet(), html("span", "carts-bar-name", tr("My answers")));
    button.setAttribute("type", "button");
    button.setAttribute("aria-haspopup", "dialog");
    button.addEventListener("click", openPanel);
    this.warning = html("p", "carts-bar-warning");
    this.warning.setAttribute("role", "alert");
    this.warning.hidden = true;
    const row = html("div", "carts-bar-row");
    row.append(this.who, this.meter, this.count, button);
    this.root.append(this.warning, row);
    if (!outline()) this.root.classList.add("carts-bar-small");
    this.onPaper = html("p", "carts-print-head");
    // Before, not in it: the theme's list of parts measures from the first thing in it.
    const main = document.querySelector("main, article") ?? document.body.firstChild;
    if (outline()) main?.before(this.onPaper);
    book.addEventListener("change", () => this.show());
    void book.ready.then(() => {
      this.show();
      this.root.dataset.ready = ""; // what was kept is back
      this.#place(); // whole: nothing in it moves any more
      this.#greet();
    });
  }

  /** Where nothing is asked, only the button is wanted: in the page's head, where it covers nothing. */
  #place() {
    const title = outline() ? null : document.querySelector(".md-header__title");
    if (title) title.after(this.root);
    else document.body.append(this.root);
  }

  /** Says whose answers these are, to whom has just given a code word; and that all was cleared. */
  #greet() {
    const { student } = this.book;
    if (recallOnce(CAME) !== student) return;
    const told = html("p", "carts-bar-told");
    told.setAttribute("role", "status");
    this.root.prepend(told);
    const words = student
      ? tr("These are the answers of {student}.", { student })
      : tr("Cleared. The next student can begin.");
    setTimeout(() => say(told, words), 0);
    setTimeout(() => told.remove(), GREETS);
  }

  show() {
    const { done, of } = this.book.progress(practised());
    this.meter.hidden = of === 0;
    this.meter.max = of || 1;
    this.meter.value = done;
    say(this.count, of ? tr("{part} of {all}", { part: done, all: of }) : "");
    this.count.dataset.short = of ? `${done}/${of}` : "";
    say(this.who, this.book.student || (outline() ? tr("no code word yet") : ""));
    this.who.hidden = !this.who.textContent;
    const code = this.book.student;
    say(this.onPaper, tr("Code word: {code}", { code: code || "____________________" }));
    const warning = this.#warning();
    say(this.warning, warning);
    this.warning.hidden = !warning;
  }

  #warning() {
    if (!outline()) return "";
    if (this.book.refused) {
      return tr("This browser refuses to keep more. Press “My answers” and save your file now.");
    }
    if (this.book.unread) {
      return tr(
        "What you answered before could not be opened. It is not lost: close other windows and load the page again.",
      );
    }
    if (!this.book.lasts) {
      return tr(
        "This browser keeps nothing: your answers are lost when you close the page. Save your file before you leave.",
      );
    }
    return "";
  }
}

/** The forms on this page that are answered like a worksheet: an exam counts its own questions. */
function practised() {
  const quizzes = /** @type {NodeListOf<HTMLElement>} */ (
    document.querySelectorAll('carts-quiz[data-mode="practice"]')
  );
  return [...quizzes].map((quiz) => quiz.dataset.form ?? "");
}
