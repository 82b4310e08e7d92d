/** The teacher's own file: a field for it, and the yellow box that asks for it. */

import { button } from "../answers/parts.js";
import { html, say } from "../shared/dom.js";
import { restored } from "./asked.js";
import { hashOf } from "./source.js";

/** @typedef {import("./session.js").Session} Session */

const LESSON = /\.(md|markdown|txt)$/i; // some editors put .txt behind the name

/**
 * A field for the teacher's own file, and beside it what is wrong with the one that was chosen.
 * @param {string} words @param {(text: string, name: string) => void | Promise<string | void>} take
 */
export function ownFile(words, take) {
  const label = html("label", "carts-teach-own");
  const told = html("span", "carts-error");
  told.setAttribute("role", "alert");
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".md,text/markdown";
  input.addEventListener("change", async () => {
    const file = input.files?.[0];
    if (!file) return;
    const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
    const bytes = await file.arrayBuffer().catch(() => null); // a file that is gone
    input.value = ""; // the same file may be chosen again
    let wrong = bytes ? "" : `${file.name} cannot be read.`;
    if (!LESSON.test(file.name)) wrong = `${file.name} is no lesson: its name would end in .md.`;
    say(told, wrong);
    if (bytes && !wrong) say(told, (await take(decoder.decode(bytes), file.name)) || "");
  });
  label.append(html("span", "", words), " ", input, " ", told);
  return label;
}

/** Asks for the file whenever notes or marking guides are missing from the text. */
export class OwnFile {
  #offer = html("p");

  /** @param {Session} session @param {(text: string) => void} tell */
  constructor(session, tell) {
    this.session = session;
    this.tell = tell;
    this.root = html("div");
    this.follow();
  }

  /** The text was changed. */
  follow() {
    const asks = this.root.firstChild !== null;
    if (asks === this.session.withheld) return;
    if (asks) this.root.replaceChildren();
    else this.root.append(this.#field());
  }

  #field() {
    const words = `Notes and marking guides for teachers are not in this page. To have them in what you save, choose your own file of the lesson (${this.session.name}):`;
    return ownFile(words, (own, name) => this.#take(own, name));
  }

  /** What is wrong with the file. @param {string} own its text @param {string} name */
  async #take(own, name) {
    this.#offer.remove();
    this.tell("Putting notes and marking guides back …");
    try {
      const { missing, same, none } = await putBack(this.session, own);
      this.tell(none ? "" : taken(missing, same));
      if (none) return strange(name, this.session.name);
    } catch (error) {
      const { message } = /** @type {Error} */ (error);
      this.tell(`Notes and marking guides could not be put back: ${message}`);
      const open = () => {
        this.#offer.remove();
        openInstead(this.session, own);
      };
      this.#offer.replaceChildren(
        "Your changes here are then not in the text: ",
        button("Open that file in place of this text", open, "carts-teach-instead"),
      );
      if (this.session.withheld) this.root.append(this.#offer);
    }
    return "";
  }
}

/** What was kept out of the site is put back into the text. @param {Session} session @param {string} own the teacher's file */
async function putBack(session, own) {
  const same = (await hashOf(own)) === session.told.hash;
  const { text, missing } = await restored(session.client, () => session.text, own);
  const none = text === session.text;
  if (same) session.base = own;
  if (!none) session.change(text, "");
  return { missing, same, none };
}

/** The teacher's own file in place of the text, as a change that can be undone. @param {Session} session @param {string} own */
function openInstead(session, own) {
  session.change(own, "");
  const { error } = session.client; // Python has gone: the pieces would not follow
  if (error) session.panel.withoutPython(error.message);
}

/** Of a file with nothing that was kept out. @param {string} name @param {string} needed */
function strange(name, needed) {
  if (name !== needed) return `This is the file ${name}; needed: ${needed}. Nothing was changed.`;
  return "No notes or marking guides of this lesson stand in this file. Nothing was changed.";
}

/** @param {number} missing @param {boolean} same whether it is the published file */
function taken(missing, same) {
  if (missing) return `${missing} notes or marking guides do not stand in this file.`;
  return same
    ? "Your file is the published one: notes and marking guides are back."
    : "Notes and marking guides are back. Your file differs from the published one.";
}
