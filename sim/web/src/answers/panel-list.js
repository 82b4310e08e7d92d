/** What was answered on this page, in words; also to questions that are no longer there. */

import { counted, tr } from "../../../view/language.js";
import { handedForms } from "../question/quiz.js";
import { html } from "../shared/dom.js";
import { isEmpty } from "./entry.js";
import { inPageOrder, isHere, outline } from "./outline.js";
import { button, part } from "./parts.js";
import { print } from "./print.js";

/** @param {import("./book.js").Book} book @returns {HTMLElement} */
export function listPart(book) {
  const root = part("list", tr("On this page"));
  const mine = book
    .entries()
    .filter(([key, entry]) => key.startsWith(`${book.page}#`) && entry?.type !== "form");
  const handed = handedForms(book);
  const shown = mine.filter(([, entry]) => !handed[entry.form] && !isEmpty(entry.value));
  const hidden = mine.filter(([, entry]) => handed[entry.form]).length;
  if (outline()) {
    const row = html("p");
    row.append(
      button(tr("Print with my answers"), () => print(false)),
      " ",
      button(tr("Print empty"), () => print(true)),
    );
    const counts = tr(
      "Counted at the foot of the page: questions and predictions, without those “for more” and those after the end of the lesson.",
    );
    root.append(row, html("p", "carts-quiet", counts));
  }
  if (!shown.length && !hidden)
    root.append(html("p", "carts-quiet", tr("No answers on this page yet.")));
  if (hidden)
    root.append(
      html(
        "p",
        "carts-quiet",
        counted(
          "1 answer of a form that was handed in is kept and not shown.",
          "{n} answers of a form that was handed in are kept and not shown.",
          hidden,
        ),
      ),
    );
  const list = html("dl", "carts-answers-said");
  for (const [, entry] of inPageOrder(shown)) {
    const note = isHere(entry) ? "" : ` ${tr("(no longer on this page)")}`;
    list.append(html("dt", "", `${entry.asked || entry.id}${note}`));
    list.append(html("dd", "", entry.said || plainValue(entry.value)));
    for (const old of entry.earlier ?? []) {
      list.append(
        html(
          "dd",
          "carts-quiet",
          tr("earlier: {answer}", { answer: old.said || plainValue(old.value) }),
        ),
      );
    }
  }
  root.append(list);
  return root;
}

/** @param {any} value */
function plainValue(value) {
  return typeof value === "string" ? value : JSON.stringify(value);
}
