/** New student, or continue as … by the code word from a printed card. Nobody else's answers are shown. */

import { tr } from "../../../view/language.js";
import { html, say } from "../shared/dom.js";
import { onEnter } from "../shared/enter.js";
import { forgetTab, retain } from "../shared/tab.js";
import { CAME } from "./bar.js";
import { readCode } from "./codes.js";
import { button, codeBox, fault, part, status } from "./parts.js";

/** @param {import("./book.js").Book} book @returns {HTMLElement} */
export function whoPart(book) {
  const root = part("who", tr("Who works here"));
  const { student } = book;
  const now = student
    ? tr("These are the answers of {student}.", { student })
    : tr("No code word yet: the next person at this computer sees these answers.");
  const { label, box } = codeBox(
    student ? tr("Somebody else? Code word") : tr("Code word from your card"),
  );
  const told = status();
  const choices = html("p", "carts-answers-choices");
  const go = button(tr("Continue"), () => void look(), "carts-answers-go");
  onEnter(box, () => void look());
  const row = html("p");
  row.append(label, " ", go);
  const two = html(
    "p",
    "carts-quiet",
    `${tr("A code word has at least four letters or digits.")} ${tr("Two students at one computer: both code words with a +.")}`,
  );
  root.append(html("p", "carts-answers-now", now), row, told, choices, two);

  async function look() {
    choices.replaceChildren();
    const found = readCode(box.value);
    if ("problem" in found) return fault(told, found.problem);
    const { code } = found;
    if (code === student) return say(told, tr("That is who works here now."));
    const here = book.entries().length > 0;
    const known = here && student ? await book.has(code) : false;
    if (!here || known) return become(code, false);
    say(
      told,
      student
        ? tr("The answers here stand under {student}. Is {code} somebody else?", { student, code })
        : tr("Somebody has answered here without a code word. Was that you?"),
    );
    choices.append(
      button(
        student
          ? tr("No, that is me: correct the code word, take them along")
          : tr("They are mine: take them along"),
        () => void become(code, true),
        "carts-answers-mine",
      ),
      " ",
      button(
        student ? tr("Yes, somebody else: begin anew") : tr("Leave them"),
        () => void become(code, false),
        "carts-answers-leave-them",
      ),
    );
    choices.querySelector("button")?.focus();
  }

  /** @param {string} code @param {boolean} carry */
  async function become(code, carry) {
    try {
      const anew = await book.become(code, carry);
      if (!carry) forgetTab();
      if (!anew) return;
      retain(CAME, code);
      location.reload();
    } catch {
      say(
        told,
        tr("This browser refuses to keep more. Press “My answers” and save your file now."),
      );
    }
  }
  return root;
}
