/** A line that says that the text is not kept, as long as it is so: neither a run nor a judge says it. */

import { tr } from "../../../view/language.js";
import { html, say } from "../shared/dom.js";

export class KeptLine {
  #puts = 0;

  /** @param {Element} owner gets `data-kept` while its newest text is kept */
  constructor(owner) {
    this.owner = owner;
    this.root = html("p", "carts-unsaved");
    this.root.setAttribute("role", "status");
  }

  /** @param {Promise<boolean> | undefined} put of the newest text: whether it is kept */
  async hear(put) {
    this.#puts += 1;
    const turn = this.#puts;
    const kept = Boolean(await put);
    if (turn !== this.#puts) return; // a newer text says it
    say(this.root, kept ? "" : tr("Not saved"));
    this.owner.toggleAttribute("data-kept", kept);
  }
}
