/** One question in words, read across the class and marked by a key: 0, 1, 2 … go on to the next. */

import { counted, tr } from "../../../view/language.js";
import { button } from "../answers/parts.js";
import { codeWord } from "../shared/code-word.js";
import { html, say } from "../shared/dom.js";

/**
 * @typedef {{lesson: string, form: string, id: string, title: string, ask: string, worth: number,
 *   rubric: Record<string, string>, answers: {student: string, shown: string, text: string, marks: number | null}[]}} Words
 */

/** @param {import("./classroom.js").Classroom} classroom @param {() => void} marked */
export function reader(classroom, marked) {
  const root = /** @type {HTMLDetailsElement} */ (html("details", "carts-class-reader"));
  const title = html("summary", "", tr("Read and mark"));
  const body = html("div");
  root.append(title, body);
  /** @type {Words[]} */
  let questions = [];
  let chosen = "";
  let at = 0;

  const name = (/** @type {Words} */ one) => `${one.lesson} · ${one.form} · ${one.id}`;
  const question = () => questions.find((one) => name(one) === chosen) ?? questions[0];

  /** @param {Words} one @param {string} student */
  const markOf = (one, student) =>
    classroom.marks.get(JSON.stringify([one.lesson, one.form, codeWord(student), one.id]))?.marks;

  /** @param {Words} one @param {number} marks */
  const give = (one, marks) => {
    const answer = one.answers[at];
    if (!answer || marks > one.worth) return;
    const { lesson, form, id: item } = one;
    classroom.mark({ lesson, form, student: answer.student, item, marks });
    at = Math.min(at + 1, one.answers.length - 1);
    show();
    marked();
  };

  const show = () => {
    const one = question();
    root.hidden = !one;
    if (!one) return;
    at = Math.min(at, one.answers.length - 1);
    const answer = one.answers[at];
    const done = one.answers.filter(({ student }) => markOf(one, student) !== undefined).length;
    const n = questions.length;
    say(title, counted("Read and mark: 1 question", "Read and mark: {n} questions", n));
    const pick = /** @type {HTMLSelectElement} */ (html("select", "carts-class-question"));
    pick.setAttribute("aria-label", tr("Question"));
    pick.append(...questions.map((q) => new Option(q.title, name(q), false, q === one)));
    pick.addEventListener("change", () => {
      chosen = pick.value;
      at = 0;
      show();
    });
    const card = html("div", "carts-class-answer");
    card.tabIndex = 0;
    card.setAttribute("role", "group");
    card.setAttribute("aria-label", tr("Answer; the keys 0, 1, 2 give marks"));
    if (answer) {
      const given = markOf(one, answer.student);
      const head = html("p", "carts-class-quiet");
      head.append(
        tr("{at} of {all}", { at: at + 1, all: one.answers.length }),
        " · ",
        html("bdi", "", answer.shown),
        " · ",
        given === undefined
          ? tr("not marked")
          : tr("{marks} of {of}", { marks: given, of: one.worth }),
      );
      card.append(head, html("p", "carts-class-text", answer.text));
    }
    const row = html("p", "carts-class-row");
    for (let marks = 0; marks <= one.worth; marks += 1) {
      row.append(
        button(String(marks), () => give(one, marks), "carts-class-mark"),
        " ",
      );
    }
    const step = (/** @type {number} */ by) => () => {
      at = Math.max(0, Math.min(one.answers.length - 1, at + by));
      show();
    };
    row.append(button(tr("Back"), step(-1)), " ", button(tr("Skip"), step(1)));
    const rubric = html("ul", "carts-class-rubric");
    for (const [marks, text] of Object.entries(one.rubric)) {
      rubric.append(html("li", "", `${marks}: ${text}`));
    }
    const focused = body.contains(document.activeElement);
    body.replaceChildren(
      pick,
      html("p", "", one.ask),
      rubric,
      card,
      row,
      html(
        "p",
        "carts-class-quiet",
        tr("{done} of {all} marked.", { done, all: one.answers.length }),
      ),
    );
    if (focused) card.focus({ preventScroll: true });
  };

  body.addEventListener("keydown", (event) => {
    const one = question();
    const inBox = event.target instanceof HTMLSelectElement;
    if (!one || inBox || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.repeat) return; // a key that is held down is one mark, not a class of them
    if (/^\d$/.test(event.key) && Number(event.key) <= one.worth) {
      event.preventDefault();
      give(one, Number(event.key));
    }
  });

  return {
    root,
    /** @param {Words[]} found */
    draw(found) {
      questions = found;
      show();
    },
  };
}
