/**
 * The prediction before the run: saved at every input, locked once, then shown beside the run.
 * Until it is locked the page knows nothing but the start state.
 */

import { isCurrent } from "./answers/outline.js";
import { need, say } from "./dom.js";
import { Again } from "./predict-again.js";
import { ArrowsForm } from "./predict-arrows.js";
import { CurveForm } from "./predict-curve.js";
import { ChoiceForm, WordsForm } from "./predict-words.js";
import { openStore, place } from "./storage.js";

/** @typedef {import("./types.js").Run} Run */
/** @typedef {import("./types.js").Baked} Baked */
/**
 * One kind of prediction. `problem` says what is still missing; `compare` shows it beside the run.
 * @typedef {{value: unknown, enable: (on: boolean) => void, problem: () => string | null,
 *   compare: (run: Run) => Node[]}} Form
 */
/** @typedef {{id: string, type: string, value: unknown, first: string | null, last: string | null, tries: number, locked: string | null, asked?: string, said?: string}} Entry */

export class Predict {
  /** @type {Entry} */
  #entry;
  /** @type {import("./storage.js").Store | null} */
  #store = null;

  /**
   * @param {HTMLElement} root of the prediction @param {Baked} baked
   * @param {(arrows: import("./predict-arrows.js").Guess[]) => void} draw arrows on the picture
   * @param {(now: boolean) => void} locked what to do once the prediction is locked; `now`: by the reader, not long ago
   * @param {() => void} forgotten what to do once the prediction is forgotten
   */
  constructor(root, baked, draw, locked, forgotten) {
    const spec = /** @type {import("./types.js").PredictSpec} */ (baked.fence.predict);
    this.root = root;
    this.spec = spec;
    this.locked = locked;
    this.saved = need(root, ".carts-saved");
    this.error = need(root, ".carts-predict-error");
    this.button = /** @type {HTMLButtonElement} */ (need(root, ".carts-lock"));
    this.#entry = {
      id: baked.fence.id,
      type: spec.kind,
      value: null,
      first: null,
      last: null,
      tries: 0,
      locked: null,
    };
    const changed = () => void this.#changed();
    const forms = {
      arrows: () => new ArrowsForm(root, baked, draw, changed),
      curve: () => new CurveForm(root, spec, changed),
      choice: () => new ChoiceForm(root, changed),
      text: () => new WordsForm(root, changed),
    };
    /** @type {Form} */
    this.form = forms[spec.kind]();
    this.button.addEventListener("click", () => void this.#lock());
    this.again = new Again(root, async () => {
      if (await this.#forget()) forgotten();
    });
  }

  /** @returns {boolean} */
  get isLocked() {
    return this.#entry.locked !== null;
  }

  /** Brings back what the reader left here before. */
  async restore() {
    const { site, page } = place();
    this.key = `${page}#${this.#entry.id}`;
    this.#store = await openStore(site);
    if (this.#store.kind === "memory") {
      say(
        this.saved,
        "This browser keeps nothing: your prediction is lost when you close the page.",
      );
    }
    const found = await this.#store.get(this.key).catch(() => null);
    if (found?.type === this.#entry.type && isCurrent(found)) {
      this.#entry = found;
      this.form.value = found.value;
      say(this.saved, "Saved.");
    }
    this.form.enable(!this.isLocked);
    this.button.disabled = this.isLocked;
    if (!this.isLocked) return;
    this.again.offer();
    this.locked(false);
  }

  /** Shows the prediction beside the run. @param {Run} run */
  compare(run) {
    const place = need(this.root, ".carts-compared");
    place.replaceChildren(...this.form.compare(run));
    place.hidden = false;
    this.again.offer();
    say(need(this.root, ".carts-heading"), "Your prediction");
    this.root.classList.add("carts-locked");
  }

  /** @returns {string} the comparison as it is read out */
  get spoken() {
    const parts = this.root.querySelectorAll(
      ".carts-compared > [aria-label], .carts-compared p, .carts-compared li",
    );
    const texts = [...parts].map((part) => part.getAttribute("aria-label") ?? part.textContent);
    return `Your prediction. ${texts.join(" ")}`;
  }

  /** @param {string} message for the reader; empty: none */
  complain(message) {
    say(this.error, message);
    this.error.hidden = !message;
  }

  async #changed() {
    const now = new Date().toISOString();
    this.#entry.value = this.form.value;
    this.#entry.asked = this.spec.ask;
    this.#entry.said = this.spec.options[Number(this.form.value)] ?? "";
    this.#entry.first ??= now;
    this.#entry.last = now;
    this.#entry.tries += 1;
    this.complain("");
    await this.#keep();
  }

  async #lock() {
    const problem = this.form.problem();
    if (problem) return this.complain(problem);
    this.#entry.value = this.form.value;
    this.#entry.locked = new Date().toISOString();
    this.form.enable(false);
    this.button.disabled = true;
    this.complain("");
    await this.#keep();
    this.again.offer();
    this.locked(true);
  }

  /** @returns {Promise<boolean>} whether the prediction is gone */
  async #forget() {
    try {
      if (this.key) await this.#store?.remove(this.key);
      return true;
    } catch {
      this.complain("This browser refuses to forget it.");
      return false;
    }
  }

  async #keep() {
    if (!this.#store || !this.key) return;
    if (this.#store.kind === "kept") say(this.saved, "Saving…");
    try {
      await this.#store.put(this.key, this.#entry);
      document.dispatchEvent(new Event("carts-kept"));
      if (this.#store.kind === "kept") say(this.saved, "Saved.");
    } catch {
      say(this.saved, "Not saved: this browser refuses to keep it. Write it on paper too.");
    }
  }
}
