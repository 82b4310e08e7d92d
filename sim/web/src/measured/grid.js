/** Readings typed into a table: a text for the reader of files. A block of cells can be pasted into it. */

import { tr } from "../../../view/language.js";
import { html } from "../shared/dom.js";

const ROWS = 10; // to begin with, and more each time
const MOST = 500;
const CARTS = ["", "A", "B"]; // of each column; the first holds times

export class Grid {
  /** @param {HTMLElement} body of the table @param {() => void} changed */
  constructor(body, changed) {
    this.body = body;
    this.changed = changed;
    this.grow();
    body.addEventListener("input", () => changed());
    body.addEventListener("paste", (event) => this.#paste(event));
  }

  grow(count = ROWS) {
    for (let k = 0; k < count && this.body.children.length < MOST; k += 1) {
      const number = this.body.children.length + 1;
      const row = html("tr");
      for (const cart of CARTS) {
        const column = cart ? tr("{letter} of {cart}", { letter: "x", cart }) : "t";
        const cell = html("td");
        const box = /** @type {HTMLInputElement} */ (html("input"));
        Object.assign(box, {
          type: "text",
          inputMode: "decimal",
          autocomplete: "off",
        });
        box.setAttribute("aria-label", tr("{column}, row {row}", { column, row: number }));
        cell.append(box);
        row.append(cell);
      }
      this.body.append(row);
    }
  }

  /** @returns {string[][]} rows up to the last one with something in it */
  get cells() {
    const rows = [...this.body.children].map((row) =>
      [...row.querySelectorAll("input")].map((box) => box.value),
    );
    while (rows.length && rows.at(-1)?.every((cell) => !cell.trim())) rows.pop();
    return rows;
  }

  /** @param {string[][]} rows */
  set cells(rows) {
    this.grow(Math.max(0, rows.length - this.body.children.length));
    const boxes = [...this.body.children].map((row) => [...row.querySelectorAll("input")]);
    for (const [k, row] of boxes.entries()) {
      for (const [j, box] of row.entries()) box.value = rows[k]?.[j] ?? "";
    }
  }

  /** @returns {string} as a file would say it; what stands in line n is row n − 1 */
  get text() {
    const rows = this.cells.map((row) => row.map((cell) => cell.trim()).join(";"));
    return ["t;x_A;x_B", ...rows].join("\n");
  }

  /** A block from a spreadsheet fills cells to the right and down. @param {ClipboardEvent} event */
  #paste(event) {
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (!/[\t\n]/.test(text.trim()) || !(event.target instanceof HTMLInputElement)) return;
    event.preventDefault();
    const block = text
      .replace(/\r\n?/g, "\n")
      .trimEnd()
      .split("\n")
      .slice(0, MOST)
      .map((line) => line.split("\t"));
    const row = event.target.closest("tr");
    const top = [...this.body.children].indexOf(/** @type {Element} */ (row));
    const left = [...(row?.querySelectorAll("input") ?? [])].indexOf(event.target);
    const all = this.cells;
    for (const [k, cells] of block.entries()) {
      all[top + k] ??= CARTS.map(() => "");
      for (const [j, cell] of cells.slice(0, CARTS.length - left).entries()) {
        /** @type {string[]} */ (all[top + k])[left + j] = cell;
      }
    }
    this.cells = Array.from(all, (cells) => cells ?? CARTS.map(() => ""));
    this.changed();
  }
}
