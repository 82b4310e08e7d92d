/** A text field with the numbers of its lines beside it; lines with a mistake are marked. */

import { html } from "../shared/dom.js";

export class Gutter {
  /** @param {string} label @param {(text: string) => void} typed */
  constructor(label, typed) {
    this.root = html("div", "carts-teach-code");
    this.numbers = html("div", "carts-teach-numbers");
    this.numbers.setAttribute("aria-hidden", "true");
    this.area = document.createElement("textarea");
    this.area.setAttribute("aria-label", label);
    this.area.setAttribute("wrap", "off");
    this.area.spellcheck = false;
    this.area.addEventListener("input", () => {
      this.#count();
      typed(this.area.value);
    });
    this.root.append(this.numbers, this.area);
    this.first = 1;
    /** @type {Set<number>} */
    this.wrong = new Set();
  }

  /** @param {string} text @param {number} first number of its first line @param {Set<number>} wrong lines */
  show(text, first, wrong) {
    const plain = text.replace(/\r\n?/g, "\n");
    if (this.area.value !== plain) {
      const { selectionStart, selectionEnd } = this.area;
      this.area.value = plain;
      this.area.setSelectionRange(selectionStart, selectionEnd);
    }
    this.first = first;
    this.wrong = wrong;
    this.area.setAttribute("aria-invalid", String(wrong.size > 0));
    this.#count();
  }

  /** @param {number} line number @param {number} col from 1 */
  goTo(line, col) {
    const lines = this.area.value.split("\n");
    const before = lines.slice(0, line - this.first).join("\n").length;
    const at = Math.min(before + (line > this.first ? 1 : 0) + col - 1, this.area.value.length);
    this.area.focus();
    this.area.setSelectionRange(at, at);
  }

  #count() {
    const count = this.area.value.replace(/\n$/, "").split("\n").length;
    this.area.rows = Math.max(2, count + (this.area.value.endsWith("\n") ? 1 : 0));
    const rows = [];
    for (let k = 0; k < count; k += 1) {
      const line = this.first + k;
      const bad = this.wrong.has(line);
      const row = html("span", bad ? "carts-teach-wrong" : "", `${bad ? "▸" : ""}${line}`);
      rows.push(row);
    }
    this.numbers.replaceChildren(...rows);
  }
}
