/** “My answers”: who works here, files, what was answered, and how to hand in. One on every page. */

import { tr } from "../../../view/language.js";
import { html } from "../shared/dom.js";
import { filesPart } from "./panel-files.js";
import { leavePart } from "./panel-leave.js";
import { listPart } from "./panel-list.js";
import { teachersPart } from "./panel-teachers.js";
import { whoPart } from "./panel-who.js";

export class Panel {
  /** @param {import("./book.js").Book} book */
  constructor(book) {
    this.book = book;
    this.root = document.createElement("dialog");
    this.root.className = "carts carts-answers";
    this.root.setAttribute("aria-labelledby", "carts-answers-title");
    document.body.append(this.root);
    book.addEventListener("change", () => {
      if (this.root.open) this.#files?.();
    });
    book.addEventListener("student", () => {
      const now = whoPart(book);
      this.#who?.replaceWith(now);
      this.#who = now;
    });
  }

  /** @type {(() => void) | null} draws the table of files anew */
  #files = null;
  /** @type {HTMLElement | null} */
  #who = null;

  async open() {
    await this.book.ready;
    await this.book.refresh();
    const title = html("h2", "carts-answers-title", tr("My answers"));
    title.id = "carts-answers-title";
    const close = html("button", "carts-button carts-answers-close", tr("Close"));
    close.setAttribute("type", "button");
    close.addEventListener("click", () => this.root.close());
    const head = html("div", "carts-answers-head");
    head.append(title, close);
    const files = filesPart(this.book);
    this.#files = files.draw;
    this.#who = whoPart(this.book);
    this.root.replaceChildren(
      head,
      this.#who,
      files.root,
      listPart(this.book),
      leavePart(this.book),
      teachersPart(),
    );
    if (!this.root.open) this.root.showModal();
  }
}
