/** The editor of one piece of a lesson: a block with its fields and its text, or Markdown. */

import { html, say } from "../shared/dom.js";
import { Fields, named } from "./fields.js";
import { Gutter } from "./gutter.js";
import { EMPTY, titleOf } from "./piece-title.js";

/** @typedef {import("./types.js").Piece} Piece */
/** @typedef {import("./types.js").Finding} Finding */

/** @type {Record<string, string>} */
const KINDS = {
  scene: "Scene",
  question: "Question",
  quiz: "Form",
  map: "Map",
  cost: "Costs",
  measured: "Real carts",
};

export class PieceEditor {
  #fields;
  #filled = false;

  /**
   * @param {{typed: (text: string) => void, set: (field: import("./types.js").Field, value: string, owner: object) => Promise<string>, opened: () => void}} acts
   */
  constructor(acts) {
    this.root = document.createElement("details");
    this.root.className = "carts-teach-piece";
    this.summary = html("summary");
    this.kind = html("span", "carts-teach-kind");
    this.title = html("span", "carts-teach-title");
    this.mark = html("span", "carts-teach-mark");
    this.summary.append(this.kind, " ", this.title, " ", this.mark);
    this.root.append(this.summary);
    this.#fields = new Fields(acts.set);
    this.text = new Gutter("Text of this block", acts.typed);
    this.prose = document.createElement("textarea");
    this.prose.className = "carts-teach-prose";
    this.prose.setAttribute("aria-label", "Text in Markdown");
    this.prose.addEventListener("input", () => acts.typed(this.prose.value));
    this.asText = document.createElement("details");
    this.asText.className = "carts-teach-text";
    this.asText.append(html("summary", "", "As text"), this.text.root);
    this.mistakes = html("ul", "carts-teach-mistakes");
    this.piece = /** @type {Piece} */ ({ kind: "text", text: "", line: 1 });
    /** @type {Finding[]} */
    this.findings = [];
    this.root.addEventListener("toggle", () => {
      if (!this.root.open) return;
      this.#fill();
      acts.opened();
    });
  }

  /** @returns {HTMLTextAreaElement} */
  get area() {
    return this.piece.kind === "text" ? this.prose : this.text.area;
  }

  /** What was typed in a field and waits for a pause is taken over now. */
  flush() {
    this.#fields.flush();
  }

  /** An undone change takes what was refused along. */
  undo() {
    this.#fields.undo();
  }

  /** @param {Piece} piece @param {Finding[]} findings @param {boolean} changed */
  show(piece, findings, changed) {
    this.piece = piece;
    this.findings = findings;
    say(this.kind, piece.kind === "block" ? (KINDS[piece.name ?? ""] ?? "Block") : place(piece));
    const title = titleOf(piece);
    say(this.title, title);
    this.root.classList.toggle("carts-teach-empty", title === EMPTY);
    const count = findings.length;
    const wrong = count ? `${count} ${count === 1 ? "mistake" : "mistakes"}` : "";
    say(this.mark, [changed ? "changed" : "", wrong].filter(Boolean).join(", "));
    this.root.classList.toggle("carts-teach-has-mistake", count > 0);
    if (this.root.open) this.#fill();
  }

  /** What is inside is made when it is opened first, and kept up to date while it is open. */
  #fill() {
    const { piece, findings } = this;
    if (!this.#filled) {
      this.#filled = true;
      const inside = html("div", "carts-teach-inside");
      if (piece.kind === "block") inside.append(this.#fields.root, this.mistakes, this.asText);
      else if (piece.kind === "text") inside.append(this.prose, this.mistakes);
      else inside.append(this.text.root, this.mistakes);
      if (!piece.fields?.length) this.asText.open = true;
      this.root.append(inside);
    }
    this.#fields.show(piece.fields ?? [], findings);
    if (piece.kind === "text") {
      const plain = piece.text.replace(/\r\n?/g, "\n");
      if (this.prose.value !== plain) this.prose.value = plain;
      this.prose.rows = Math.max(3, Math.ceil(plain.length / 50) + plain.split("\n").length / 2);
    } else this.text.show(piece.text, piece.line, new Set(findings.map((finding) => finding.line)));
    this.#list(findings);
  }

  /** @param {Finding[]} findings */
  #list(findings) {
    const rows = findings.map((finding) => {
      const row = html("li");
      const go = html("button", "carts-button", `line ${finding.line}`);
      go.setAttribute("type", "button");
      go.addEventListener("click", () => this.goTo(finding));
      row.append(
        go,
        " ",
        html("span", "carts-teach-message", named(this.piece.fields ?? [], finding)),
      );
      if (finding.hint) row.append(" ", html("span", "carts-teach-hint", finding.hint));
      row.dataset.place = `${finding.file}:${finding.line}:${finding.col}`;
      return row;
    });
    this.mistakes.replaceChildren(...rows);
    this.mistakes.hidden = rows.length === 0;
    if (rows.length && !this.piece.fields?.length) this.asText.open = true;
  }

  /** @param {Finding} finding */
  goTo({ line, col }) {
    this.root.open = true;
    this.asText.open = true;
    if (this.piece.kind === "text") this.prose.focus();
    else this.text.goTo(line, col);
  }
}

/** @param {Piece} piece */
const place = (piece) => (piece.kind === "top" ? "Facts" : "Text");
