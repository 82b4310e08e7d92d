/** Slips for each student and the page of the class: made in Python, shown, and printed alone. */

import { tr } from "../../../view/language.js";
import { button } from "../answers/parts.js";
import { html } from "../shared/dom.js";
import { printWith } from "../shared/printing.js";

/** @typedef {Record<string, {name: string, words: Record<string, string>}>} Languages */

const PRINTING = "carts-class-paper-only";

/** @returns {Languages} see sim/pages/classroom/practice_keys.py */
const languages = () =>
  /** @type {any} */ (globalThis).__cartsPapers ?? { en: { name: "English", words: {} } };

/** The language of the page, with what each English sentence is in it. @returns {{language: string, words: Record<string, string>}} */
export function spokenHere() {
  const spoken = languages();
  const own = document.documentElement.lang;
  const base = own.split("-")[0];
  const codes = Object.keys(spoken);
  const language = codes.find((c) => c === own) ?? codes.find((c) => c.split("-")[0] === base);
  return { language: language ?? "en", words: spoken[language ?? ""]?.words ?? {} };
}

/**
 * @param {{noAnswers: () => boolean, keys: () => string[], ask: (wanted: Record<string, unknown>) => Promise<Record<string, any>>,
 *   say: (text: string) => void}} given
 */
export function papers({ noAnswers, keys, ask, say }) {
  const root = html("div", "carts-class-papers");
  const shown = html("div", "carts-class-paper");
  const spoken = languages();
  const pick = /** @type {HTMLSelectElement} */ (html("select", "carts-class-language"));
  pick.setAttribute("aria-label", tr("Language of the slips and of the page of the class"));
  pick.append(
    ...Object.entries(spoken).map(([code, { name }]) => {
      const option = /** @type {HTMLOptionElement} */ (html("option", "", name));
      option.value = code;
      option.lang = code;
      return option;
    }),
  );
  pick.value = spokenHere().language;
  const answers = /** @type {HTMLInputElement} */ (html("input", "carts-class-with-answers"));
  answers.type = "checkbox";
  const label = html("label", "carts-class-choice");
  label.append(answers, " ", tr("slips with the right answers"));
  /** @param {"slips" | "sheet" | "key"} what */
  const make = (what) => async () => {
    try {
      say(tr("Making the pages …"));
      const wanted = { what, language: pick.value, words: spoken[pick.value]?.words ?? {} };
      const dropped = what === "key" ? { keys: keys() } : {}; // not what can be practised
      const header = await ask({ do: "paper", ...wanted, ...dropped, answers: answers.checked });
      shown.innerHTML = header.html; // escaped where it was made
      shown.lang = pick.value;
      say("");
      print();
    } catch (error) {
      say(/** @type {Error} */ (error).message);
    }
  };
  const row = html("p", "carts-class-row");
  row.append(
    button(tr("Print slips for students"), make("slips"), "carts-class-slips"),
    button(tr("Print page of the class"), make("sheet"), "carts-class-sheet"),
    pick,
    label,
  );
  const key = button(tr("Print answers and rubrics"), make("key"), "carts-class-print-key");
  const ofTeacher = html("p", "carts-class-row");
  ofTeacher.append(key);
  root.append(row, ofTeacher);
  const draw = () => {
    row.hidden = noAnswers();
    ofTeacher.hidden = !keys().length;
    root.hidden = row.hidden && ofTeacher.hidden;
    shown.replaceChildren(); // of other answers by now
  };
  return { root, shown, draw };
}

/** Prints the paper alone, without the report. */
function print() {
  const { classList } = document.documentElement;
  classList.add(PRINTING);
  printWith(() => classList.remove(PRINTING));
}
