/** The teacher's own file: a field for it, and the yellow box that asks for it. */

import { button } from "../answers/parts.js";
import { html, say } from "../shared/dom.js";
import { restored } from "./asked.js";
import { hashOf } from "./source.js";

/** @typedef {import("./session.js").Session} Session */

/** A field for the teacher's own file. @param {string} words @param {(text: string) => void} take */
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
    say(told, bytes ? "" : `${file.name} cannot be read.`);
    if (bytes) take(decoder.decode(bytes));
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
    return ownFile(words, (own) => void this.#take(own));
  }

  /** @param {string} own */
  async #take(own) {
    this.#offer.remove();
    this.tell("Putting notes and marking guides back …");
    try {
      const { missing, same } = await putBack(this.session, own);
      this.tell(taken(missing, same));
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
  }
}

/** What was kept out of the site is put back into the text. @param {Session} session @param {string} own the teacher's file */
async function putBack(session, own) {
  const same = (await hashOf(own)) === session.told.hash;
  const { text, missing } = await restored(session.client, () => session.text, own);
  if (same) session.base = own;
  session.change(text, "");
  return { missing, same };
}

/** The teacher's own file in place of the text, as a change that can be undone. @param {Session} session @param {string} own */
function openInstead(session, own) {
  session.change(own, "");
  const { error } = session.client; // Python has gone: the pieces would not follow
  if (error) session.panel.withoutPython(error.message);
}

/** @param {number} missing @param {boolean} same whether it is the published file */
function taken(missing, same) {
  if (missing) return `${missing} notes or marking guides do not stand in this file.`;
  return same
    ? "Your file is the published one: notes and marking guides are back."
    : "Notes and marking guides are back. Your file differs from the published one.";
}
