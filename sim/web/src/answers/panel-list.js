/** What was answered on this page, in words; also to questions that are no longer there. */

import { html } from "../dom.js";
import { handedForms } from "../question/quiz.js";
import { isEmpty } from "./entry.js";
import { itemOf, outline } from "./outline.js";
import { button, part } from "./parts.js";

/** @param {import("./book.js").Book} book @returns {HTMLElement} */
export function listPart(book) {
  const root = part("list", "On this page");
  const mine = book
    .entries()
    .filter(([key, entry]) => key.startsWith(`${book.page}#`) && entry?.type !== "form");
  const handed = handedForms(book);
  const shown = mine.filter(([, entry]) => !handed[entry.form] && !isEmpty(entry.value));
  const hidden = mine.filter(([, entry]) => handed[entry.form]).length;
  if (outline()) {
    const row = html("p");
    row.append(
      button("Print with my answers", () => print(false)),
      " ",
      button("Print empty", () => print(true)),
    );
    root.append(row);
  }
  if (!shown.length) root.append(html("p", "carts-quiet", "Nothing to show."));
  if (hidden)
    root.append(
      html(
        "p",
        "carts-quiet",
        `${hidden} answers of a form that was handed in are kept and not shown.`,
      ),
    );
  const list = html("dl", "carts-answers-said");
  for (const [, entry] of shown) {
    const there = itemOf(entry);
    const note = there ? "" : " (no longer on this page)";
    list.append(html("dt", "", `${entry.asked || entry.id}${note}`));
    list.append(html("dd", "", entry.said || plainValue(entry.value)));
    for (const old of entry.earlier ?? []) {
      list.append(html("dd", "carts-quiet", `earlier: ${old.said || plainValue(old.value)}`));
    }
  }
  root.append(list);
  return root;
}

/** @param {any} value */
function plainValue(value) {
  return typeof value === "string" ? value : JSON.stringify(value);
}

/** @param {boolean} empty without the answers, to be filled in by hand */
function print(empty) {
  document.documentElement.classList.toggle("carts-print-empty", empty);
  for (const dialog of document.querySelectorAll("dialog")) dialog.close();
  window.print();
}
