/** Pieces that the parts of the panel share. */

import { tr } from "../../../view/language.js";
import { html } from "../shared/dom.js";

/** A part of the panel with its heading. @param {string} name of the class @param {string} title @returns {HTMLElement} */
export function part(name, title) {
  const made = html("section", `carts-answers-part carts-answers-${name}`);
  made.append(html("h3", "", title));
  return made;
}

/** @param {string} text @param {() => void} act @param {string} name of the class @returns {HTMLButtonElement} */
export function button(text, act, name = "") {
  const made = /** @type {HTMLButtonElement} */ (
    html("button", `carts-button ${name}`.trim(), text)
  );
  made.type = "button";
  made.addEventListener("click", act);
  return made;
}

let count = 0; // of buttons that ask

/** A button that asks before it acts, in the page. @param {string} text @param {string} question @param {string} yes @param {() => void} act @param {string} name @param {string} not what is pressed else */
export function askingButton(text, question, yes, act, name, not = tr("No")) {
  const row = html("p", `carts-answers-asking ${name}`);
  const first = button(text, () => ask(true));
  const asked = html("span");
  const words = html("span", "", question);
  count += 1;
  words.id = `${name}-${count}`; // said with each of the buttons: the focus goes to one
  const no = button(not, () => ask(false), "carts-answers-no");
  const go = () => {
    ask(false); // before: the act may lead elsewhere
    act();
  };
  const does = button(yes, go, "carts-answers-yes");
  for (const one of [does, no]) one.setAttribute("aria-describedby", words.id);
  asked.append(words, " ", does, " ", no);
  asked.hidden = true;
  row.append(first, asked);
  /** @param {boolean} on */
  function ask(on) {
    first.hidden = on;
    asked.hidden = !on;
    (on ? no : first).focus();
  }
  return row;
}

/** A box for a code word, with its label. @param {string} text @returns {{label: HTMLElement, box: HTMLInputElement}} */
export function codeBox(text) {
  const label = html("label", "", `${text} `);
  const box = /** @type {HTMLInputElement} */ (html("input", "carts-answers-code"));
  Object.assign(box, { type: "text", maxLength: 90, autocomplete: "off", spellcheck: false });
  box.placeholder = "BLUE-FOX-27";
  label.append(box);
  return { label, box };
}

/** @returns {HTMLElement} a line that is read out when its text changes */
export function status() {
  const made = html("p", "carts-answers-status");
  made.setAttribute("role", "status");
  return made;
}

/** Says in such a line why something was not done. @param {HTMLElement} line @param {string} problem */
export function fault(line, problem) {
  line.replaceChildren(html("b", "carts-answers-fault", problem));
}

/** @param {string | null | undefined} time ISO @returns {string} on this computer's clock */
export function clock(time) {
  const date = new Date(time ?? "");
  return Number.isNaN(date.getTime())
    ? ""
    : date.toLocaleString(document.documentElement.lang || [], {
        dateStyle: "medium",
        timeStyle: "short",
      });
}
