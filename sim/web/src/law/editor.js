/**
 * The text of a law. The Tab key goes on to the next button, as everywhere; Enter begins the next
 * line below the first letter of this one, four spaces further after a colon.
 */

import { tr } from "../../../view/language.js";
import { html } from "../shared/dom.js";
import { isEnter } from "../shared/enter.js";

const STEP = "    ";
export const LONGEST = 20_000; // characters: what an answer may have; a test holds it to that

export class Editor {
  /** @param {string} id @param {(text: string) => void} changed */
  constructor(id, changed) {
    this.root = html("div", "carts-law-editor");
    const label = html("label", "carts-heading", tr("Your law, in Python"));
    label.setAttribute("for", `${id}-text`);
    this.box = document.createElement("textarea");
    Object.assign(this.box, { id: `${id}-text`, rows: 10, spellcheck: false, wrap: "off" });
    this.box.maxLength = LONGEST;
    this.box.setAttribute("autocapitalize", "off");
    this.box.setAttribute("autocomplete", "off");
    this.box.setAttribute("aria-describedby", `${id}-gets`);
    this.box.addEventListener("input", () => changed(this.box.value));
    this.box.addEventListener("keydown", (event) => this.#key(event));
    const gets = html(
      "p",
      "carts-quiet",
      tr(
        "force is asked once for each of the two carts while they touch, and returns N: above 0 it pushes away from the other. It may ask for: {names}.",
        { names: ARGUMENTS.join(", ") },
      ),
    );
    gets.id = `${id}-gets`;
    this.root.append(label, this.box, gets);
  }

  get text() {
    return this.box.value;
  }

  set text(text) {
    this.box.value = text;
    this.box.rows = Math.min(24, Math.max(8, text.split("\n").length + 1));
  }

  /** The cursor goes to a line. @param {number} line from 1 */
  go(line) {
    const lines = this.box.value.split("\n");
    const start = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
    this.box.focus();
    this.box.setSelectionRange(start, start + (lines[line - 1] ?? "").length);
    this.box.scrollTop = ((line - 2) * this.box.scrollHeight) / lines.length; // with the one above it
    this.box.scrollLeft = 0;
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (!isEnter(event) || event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return;
    const { value, selectionStart } = this.box;
    const line = value.slice(value.lastIndexOf("\n", selectionStart - 1) + 1, selectionStart);
    const indent = /^ */.exec(line)?.[0] ?? "";
    const more = /:\s*(#.*)?$/.test(line) ? STEP : "";
    event.preventDefault();
    // The browser's own way of typing, so that it can be undone; where there is none, without.
    if (document.execCommand("insertText", false, `\n${indent}${more}`)) return;
    this.box.setRangeText(`\n${indent}${more}`, selectionStart, this.box.selectionEnd, "end");
    this.box.dispatchEvent(new Event("input", { bubbles: true }));
  }
}

/** As in sim/mine/arguments.py; a test holds the two together. */
export const ARGUMENTS = [
  "overlap",
  "rate",
  "mass_self",
  "mass_other",
  "reduced_mass",
  "velocity_self",
  "velocity_other",
  "time",
  "stiffness",
  "restitution",
  "name_self",
  "name_other",
  "side",
];
