/** The panel of teacher mode beside the lesson: what can be changed, piece by piece. */

import { html, say } from "../shared/dom.js";
import { earlierDraft } from "./earlier-draft.js";
import { head } from "./head.js";
import { OwnFile, ownFile } from "./own-file.js";
import { PieceEditor } from "./piece.js";
import { toolbar } from "./saves.js";

/** @typedef {import("./types.js").Look} Look */

export class Panel {
  /** @type {PieceEditor[]} */
  #editors = [];
  /** @type {import("./types.js").Piece[]} */
  #pieces = [];
  /** @type {Set<string>} texts of the published pieces */
  #published = new Set();
  #base = "";
  /** @type {PieceEditor | null} of the whole text, where Python does not answer */
  #whole = null;

  /** @param {import("./session.js").Session} session */
  constructor(session) {
    this.session = session;
    this.root = html("aside", "carts carts-teach");
    this.root.setAttribute("aria-label", "Change this lesson");
    const { root, heading } = head(session, this.root);
    this.heading = heading;
    this.note = html("p", "carts-teach-status");
    this.note.setAttribute("role", "status");
    this.state = html("p", "carts-teach-state");
    this.state.setAttribute("role", "status");
    this.tools = toolbar(session, (text, kind) => this.status(text, kind));
    this.own = new OwnFile(session, (text) => this.status(text));
    this.notices = html("div", "carts-teach-notices");
    this.list = html("div", "carts-teach-pieces");
    const body = html("div", "carts-teach-body");
    body.append(this.own.root, this.notices, this.list);
    // Beside what scrolls, not in it: what is said of a save is seen wherever a teacher is at work.
    const bar = html("div", "carts-teach-bar");
    bar.append(this.tools.root, this.note, this.state);
    this.root.append(root, bar, body);
  }

  get #unchanged() {
    return this.session.told.text === null ? "As in your file." : "As published.";
  }

  focus() {
    this.heading.focus();
  }

  /** What was typed in fields and waits for a pause is taken over now. */
  flush() {
    for (const editor of this.#editors) editor.flush();
  }

  /** An undone change takes what was refused along. */
  undo() {
    for (const editor of this.#editors) editor.undo();
  }

  /** @param {string} text @param {import("./types.js").Kind} kind what speaks of mistakes goes when they have gone */
  status(text, kind = "") {
    this.note.dataset.kind = kind;
    say(this.note, text);
  }

  /** Whether the draft is on this computer. @param {boolean} kept */
  kept(kept) {
    const words = kept
      ? "Draft kept in this browser."
      : "This browser keeps no drafts: save often.";
    say(this.state, this.session.changed ? words : this.#unchanged);
    this.root.dataset.kept = String(kept);
  }

  /** The text was changed: what can be told before Python has looked. */
  follow() {
    this.root.dataset.state = this.#whole ? "unchecked" : "looking";
    this.#whole?.show(whole(this.session.text), [], false);
    this.tools.draw();
    this.own.follow();
  }

  /** The page shows the text as it is. */
  drawn() {
    this.root.dataset.state = "ready";
  }

  /** @param {Look} look at the text without changes @param {string} base that text */
  published({ pieces }, base) {
    this.#base = base;
    this.#published = new Set(pieces.map((piece) => piece.text));
  }

  /** @param {Look} look */
  take(look) {
    const { pieces, findings } = look;
    if (this.#base !== this.session.base && this.session.text === this.session.base)
      this.published(look, this.session.base);
    if (shape(pieces) !== shape(this.#pieces)) this.#build(pieces);
    this.#pieces = pieces;
    const file = this.session.told.file;
    pieces.forEach((piece, k) => {
      const next = pieces[k + 1]?.line ?? Number.POSITIVE_INFINITY;
      const own = findings.filter(
        ({ line, file: where }) => where === file && line >= piece.line && line < next,
      );
      const last = k === pieces.length - 1;
      const others = last ? findings.filter(({ file: where }) => where !== file) : [];
      const changed = this.#published.size > 0 && !this.#published.has(piece.text);
      this.#editors[k]?.show(piece, [...own, ...others], changed);
    });
    const count = findings.length;
    this.root.dataset.mistakes = String(count);
    const words = count === 1 ? "1 mistake" : `${count} mistakes`;
    const faulty = this.#editors.filter((editor) => editor.findings.length);
    const closed = faulty.length > 0 && !faulty.some((editor) => editor.root.open); // said nowhere else
    const where = closed ? ` The first is in “${faulty[0]?.title.textContent}”: open it.` : "";
    if (count)
      this.status(`${words}: the page shows these parts as they were before.${where}`, "fault");
    else if (this.note.dataset.kind === "fault") this.status("");
    if (!this.state.textContent) say(this.state, this.#unchanged);
    this.tools.draw();
  }

  /** @param {import("./types.js").Piece[]} pieces */
  #build(pieces) {
    const open = new Set(
      this.#editors.filter((e) => e.root.open).map((e) => e.piece.id || e.piece.line),
    );
    const typing = this.#editors.find((editor) => editor.area === document.activeElement);
    const before = typing ? this.#editors.indexOf(typing) : -1;
    let at = typing?.area.selectionStart ?? 0;
    for (let k = 0; k < before; k += 1) at += plain(this.#pieces[k]?.text ?? "").length;
    this.#editors = pieces.map((piece, k) => {
      const editor = new PieceEditor({
        typed: (text) => this.#typed(k, text),
        set: (field, value, owner) => this.session.set(this.#blockOf(k), field, value, owner),
        opened: () => this.session.page.reveal(this.#blockOf(k)),
      });
      editor.piece = piece;
      editor.root.open = open.has(piece.id || piece.line);
      return editor;
    });
    this.list.replaceChildren(...this.#editors.map((editor) => editor.root));
    if (before < 0) return;
    // What was typed has made two pieces of one, or one of two: the caret goes on where it was.
    for (const [k, piece] of pieces.entries()) {
      const { length } = plain(piece.text);
      if (at <= length) return this.#caret(k, at);
      at -= length;
    }
  }

  /** @param {number} k @param {number} at */
  #caret(k, at) {
    const editor = this.#editors[k];
    if (!editor) return;
    editor.root.open = true;
    queueMicrotask(() => {
      editor.asText.open = true;
      editor.area.focus();
      editor.area.setSelectionRange(at, at);
    });
  }

  /** @param {number} k @param {string} typed */
  #typed(k, typed) {
    const piece = this.#pieces[k];
    if (!piece) return;
    const ends = piece.text.includes("\r\n") ? typed.replaceAll("\n", "\r\n") : typed;
    const texts = this.#pieces.map(({ text }, other) => (other === k ? ends : text));
    this.#pieces = this.#pieces.map((one, other) => (other === k ? { ...one, text: ends } : one));
    this.session.change(texts.join(""), `piece ${k}`);
  }

  /** The number of a piece's block among the blocks. @param {number} k */
  #blockOf(k) {
    if (this.#pieces[k]?.kind !== "block") return -1;
    return this.#pieces.slice(0, k).filter((piece) => piece.kind === "block").length;
  }

  /** Opens the editor of a block. @param {number} index among the blocks */
  openBlock(index) {
    const editor = this.#editors.filter(({ piece }) => piece.kind === "block")[index];
    if (!editor) return;
    editor.root.open = true;
    editor.root.scrollIntoView({ block: "start" });
    editor.summary.focus();
  }

  /** A lesson whose text is not in the site. */
  askForFile() {
    this.root.dataset.state = "asks";
    this.tools.root.hidden = true;
    const words = `This lesson has a test, so its text is not in the site. Choose your own file (${this.session.name}):`;
    this.notices.replaceChildren(
      ownFile(words, (text) => {
        this.tools.root.hidden = false;
        this.notices.replaceChildren();
        void this.session.openOwn(text);
      }),
    );
  }

  /** @param {import("./drafts.js").Draft[]} drafts */
  offerEarlier(drafts) {
    this.notices.append(...drafts.map((draft) => earlierDraft(this.session, draft)));
  }

  /** The whole text can still be changed and saved. @param {string} why */
  withoutPython(why) {
    this.status(`${why} The text is not checked here, and the page does not follow.`);
    const editor = new PieceEditor({
      typed: (text) => this.session.change(text, "all"),
      set: async () => "",
      opened: () => {},
    });
    editor.show(whole(this.session.text), [], false);
    this.#whole = editor;
    editor.root.open = true;
    this.list.replaceChildren(editor.root);
    this.root.dataset.state = "unchecked";
  }
}

/** @param {string} text @returns {import("./types.js").Piece} */
const whole = (text) => ({ kind: "top", text, line: 1 });

/** @param {import("./types.js").Piece[]} pieces */
const shape = (pieces) => pieces.map(({ kind, name, id }) => `${kind} ${name} ${id}`).join("\n");

/** @param {string} text */
const plain = (text) => text.replace(/\r\n?/g, "\n");
