/** A prediction is kept, and the page says so. */

import { tr } from "../../../view/language.js";
import { isCurrent } from "../answers/outline.js";
import { need, say } from "../shared/dom.js";
import { Kept } from "../store/kept.js";

/** @typedef {import("./predict.js").Entry} Entry */

export class Keeping {
  #kept;

  /** @param {HTMLElement} root of the prediction @param {string} id @param {AbortSignal} signal another prediction takes its place */
  constructor(root, id, signal) {
    this.root = root;
    this.signal = signal;
    this.saved = need(root, ".carts-saved");
    this.#kept = new Kept(id);
  }

  /**
   * Resolves with what the reader left here before, where it answers what is asked today; else null.
   * @param {string} type of prediction @param {(found: Entry | null) => void} elsewhere what to do with what another tab keeps; null: it has forgotten it
   * @returns {Promise<Entry | null>}
   */
  async open(type, elsewhere) {
    const current = (/** @type {any} */ found) => found?.type === type && isCurrent(found);
    void this.#kept.hear((found) => {
      if (this.root.isConnected && (!found || current(found))) elsewhere(found);
    }, this.signal);
    if (!(await this.#kept.lasts())) {
      say(
        this.saved,
        tr("This browser keeps nothing: your prediction is lost when you close the page."),
      );
    }
    const found = await this.#kept.get();
    return current(found) ? found : null;
  }

  /** @param {Entry} entry */
  async put(entry) {
    const lasts = await this.#kept.lasts();
    if (lasts) say(this.saved, tr("Saving…"));
    try {
      await this.#kept.put(entry);
      if (lasts) say(this.saved, tr("Saved."));
    } catch {
      say(this.saved, tr("Not saved: this browser refuses to keep it. Write it on paper too."));
    }
  }

  /**
   * Who starts again is the next reader at this computer; under a code word it is the same student, who has
   * seen the run. That stays, so that nobody takes the next prediction for one before the run.
   * @param {Entry} entry
   */
  async forget({ id, type, locked, again = locked ?? undefined }) {
    await this.#kept.forget();
    if (!again || !(await this.#kept.named())) return;
    const nothing = { value: null, first: null, last: null, tries: 0, locked: null };
    await this.#kept.put({ id, type, ...nothing, again }).catch(() => {}); // the prediction is gone all the same
  }
}
