/** Where a prediction is kept, and what the page says of it. */

import { tr } from "../../../view/language.js";
import { isCurrent } from "../answers/outline.js";
import { need, say } from "../shared/dom.js";
import { openStore, place } from "../shared/storage.js";

/** @typedef {import("./predict.js").Entry} Entry */

export class Keeping {
  /** @type {import("../shared/storage.js").Store | null} */
  #store = null;
  #key = "";

  /** @param {HTMLElement} root of the prediction */
  constructor(root) {
    this.root = root;
    this.saved = need(root, ".carts-saved");
  }

  /**
   * Resolves with what the reader left here before, where it answers what is asked today; else null.
   * @param {Entry} entry as it is before @param {(found: Entry) => void} elsewhere what to do with what another tab keeps
   * @returns {Promise<Entry | null>}
   */
  async open({ id, type }, elsewhere) {
    const { site, page } = place();
    const key = `${page}#${id}`;
    const store = await openStore(site);
    this.#store = store;
    this.#key = key;
    if (store.kind === "memory") {
      say(
        this.saved,
        tr("This browser keeps nothing: your prediction is lost when you close the page."),
      );
    }
    const get = async () => {
      const found = await store.get(key).catch(() => null);
      return found?.type === type && isCurrent(found) ? found : null;
    };
    store.hear(async (told) => {
      const found = told === key ? await get() : null;
      if (found && this.root.isConnected) elsewhere(found);
    });
    return get();
  }

  /** @param {Entry} entry */
  async put(entry) {
    if (!this.#store) return;
    const { kind } = this.#store;
    if (kind === "kept") say(this.saved, tr("Saving…"));
    try {
      await this.#store.put(this.#key, entry);
      document.dispatchEvent(new Event("carts-kept"));
      if (kind === "kept") say(this.saved, tr("Saved."));
    } catch {
      say(this.saved, tr("Not saved: this browser refuses to keep it. Write it on paper too."));
    }
  }

  async forget() {
    await this.#store?.remove(this.#key);
  }
}
