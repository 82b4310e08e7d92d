/**
 * The prediction before the run: saved at every input, locked once, then shown beside the run.
 * Until it is locked the page knows nothing but the start state.
 */

import { tr } from "../../../view/language.js";
import { html, need, say } from "../shared/dom.js";
import { Again } from "./again.js";
import { ArrowsForm } from "./arrows.js";
import { CurveForm } from "./curve.js";
import { Keeping } from "./keeping.js";
import { RelativeArrows } from "./relative.js";
import { Sure } from "./sure.js";
import { Talk, Why } from "./talk.js";
import { ChoiceForm, WordsForm } from "./words.js";

/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {import("../../../view/types.js").Baked} Baked */
/**
 * One kind of prediction. `problem` says what is still missing; `compare` shows it beside the run.
 * `said` is the prediction in words; `ready`: it may be drawn in the picture; `once`: the question comes back after the run.
 * @typedef {{value: unknown, readonly said: string, enable: (on: boolean) => void, problem: () => string | null,
 *   compare: (run: Run) => Node[], ready?: () => void, once?: import("./once-more.js").OnceMore}} Form
 */
/** @typedef {{id: string, type: string, value: unknown, first: string | null, last: string | null, tries: number, locked: string | null, asked?: string, said?: string, sure?: string, watched?: string,
 *   talk?: string, before?: {value: unknown, said: string}, why?: string, now?: string, again?: string}} Entry
 * watched: when its run was first seen to the end; talk: when it was locked for the first time; before: what it was until it was changed after talking; now: the same question after the run; again: when an earlier one of this student was locked, who has seen the run since */

export class Predict {
  /** @type {Entry} */
  #entry;
  /** @type {Keeping} */
  #keeping;

  /**
   * @param {HTMLElement} root of the prediction @param {Baked} baked
   * @param {(arrows: import("./arrows.js").Guess[]) => void} draw arrows on the picture
   * @param {(now: boolean) => void} locked what to do once the prediction is locked; `now`: by the reader, not long ago
   * @param {(now: boolean) => void} forgotten what to do once the prediction is forgotten; `now`: by the reader, in this tab @param {AbortSignal} signal another takes its place
   */
  constructor(root, baked, draw, locked, forgotten, signal) {
    const spec = /** @type {import("../../../view/types.js").PredictSpec} */ (baked.fence.predict);
    this.root = root;
    this.spec = spec;
    this.forgotten = forgotten;
    this.locked = (/** @type {boolean} */ now) => {
      draw([]); // the carts leave the place for which it was drawn; the comparison shows it again
      say(need(root, ".carts-heading"), tr("Your prediction")); // nothing is asked any more
      root.classList.add("carts-locked");
      locked(now);
    };
    this.#keeping = new Keeping(root, baked.fence.id, signal);
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
      arrows: () =>
        new (spec.scale === "newtons" ? ArrowsForm : RelativeArrows)(root, baked, draw, changed),
      curve: () => new CurveForm(root, spec, changed),
      choice: () => new ChoiceForm(root, changed),
      text: () => new WordsForm(root, changed),
    };
    /** @type {Form} */
    this.form = forms[spec.kind]();
    this.sure = new Sure(root, (word) => {
      this.#entry.sure = word;
      void this.#keep();
    });
    this.button.addEventListener("click", () => void this.#lock());
    this.talk = new Talk(root, { change: () => this.#change(), run: () => void this.#finish() });
    this.why = new Why(root, (text) => {
      this.#entry.why = text;
      this.#told();
      void this.#keep();
    });
    this.again = new Again(root, async () => {
      if (await this.#forget()) forgotten(true);
    });
  }

  /** @returns {boolean} */
  get isLocked() {
    return Boolean(this.#entry.locked); // a file says nothing of one that is not
  }

  /** @returns {boolean} whether the run was seen to its end, now or at an earlier visit */
  get watched() {
    return Boolean(this.#entry.watched);
  }

  /** Brings back what the reader left here before. */
  async restore() {
    const found = await this.#keeping.open(this.spec.kind, (found) => this.#elsewhere(found));
    this.#back(found ?? this.#entry);
    if (found?.last) say(this.#keeping.saved, tr("Saved."));
  }

  /** Another tab has kept this prediction, or forgotten it (null). What is locked here else stays so. @param {Entry | null} found */
  #elsewhere(found) {
    if (!found) return this.forgotten(false);
    if (!this.isLocked) return this.#back(found);
    if (!found.locked) return;
    this.#entry = found;
    if (this.watched) this.why.show(found.why ?? "");
  }

  /** The page with what the reader said before. @param {Entry} entry */
  #back(entry) {
    this.#entry = entry;
    if (entry.value !== null) this.form.value = entry.value;
    const talking = Boolean(this.#entry.talk) && !this.#entry.before;
    const open = !this.isLocked && !talking;
    this.form.enable(open);
    this.sure.show(this.#entry.sure, open);
    this.button.disabled = !open;
    this.talk.show(!this.isLocked && talking, false);
    if (this.#entry.before) this.#showAgain();
    if (!this.isLocked) return this.form.ready?.();
    this.again.offer();
    this.locked(false);
  }

  /** Shows the prediction beside the run. @param {Run} run */
  compare(run) {
    const place = need(this.root, ".carts-compared");
    place.replaceChildren(...this.form.compare(run));
    const { before, why } = this.#entry;
    if (before) {
      const both = tr("First you said: {first}. After talking you said: {second}.", {
        first: before.said.replace(/[.。]$/, ""),
        second: this.form.said.replace(/[.。]$/, ""),
      });
      place.append(html("p", "", both));
    }
    const once = this.form.once?.draw(this.#entry.now ?? null, (now) => {
      this.#entry.now = now;
      this.#told();
      void this.#keep();
    });
    place.append(once ?? "");
    place.hidden = false;
    if (!this.#entry.watched) {
      this.#entry.watched = new Date().toISOString();
      void this.#keep();
    }
    this.why.show(why ?? "");
    this.again.offer();
  }

  /** @returns {string} the comparison as it is read out */
  get spoken() {
    const parts = this.root.querySelectorAll(
      ".carts-compared > [aria-label], .carts-compared p, .carts-compared li",
    );
    const texts = [...parts].map((part) => part.getAttribute("aria-label") ?? part.textContent);
    return `${tr("Your prediction.")} ${texts.join(" ")}`;
  }

  /** @param {string} message for the reader; empty: none */
  complain(message) {
    say(this.error, message);
    this.error.hidden = !message;
  }

  async #changed() {
    if (this.isLocked) return;
    this.#entry.value = this.form.value;
    this.#entry.asked = this.spec.ask;
    this.#told();
    this.#entry.first ??= new Date().toISOString();
    this.#entry.tries += 1;
    this.complain("");
    await this.#keep();
  }

  async #lock() {
    const problem = this.form.problem() || this.sure.passedOver();
    if (problem) return this.complain(problem);
    this.#entry.value = this.form.value;
    this.#entry.asked = this.spec.ask;
    this.#entry.first ??= new Date().toISOString();
    this.#told(); // by the lock too: what was not drawn is no force
    this.form.enable(false);
    this.sure.show(this.#entry.sure, false);
    this.button.disabled = true;
    this.complain("");
    if (!this.spec.talk || this.#entry.talk) return this.#finish();
    this.#entry.talk = new Date().toISOString();
    await this.#keep();
    this.talk.show(true, true);
  }

  /** After talking: once more, and then the run. */
  #change() {
    this.#entry.before = { value: this.#entry.value, said: this.form.said };
    this.talk.show(false, true);
    this.form.enable(true);
    this.sure.show(this.#entry.sure, true);
    this.#showAgain();
    this.button.disabled = false;
    void this.#keep();
  }

  #showAgain() {
    say(this.button, tr("Lock the changed prediction and show the run"));
  }

  async #finish() {
    this.#entry.locked = new Date().toISOString();
    this.talk.show(false, true);
    await this.#keep();
    this.again.offer();
    this.locked(true);
  }

  /** The prediction in words, as the list of answers shows it. */
  #told() {
    const { before, why, now } = this.#entry;
    const parts = [this.form.said];
    if (now) parts.push(tr("After the run: {said}", { said: this.form.once?.said(now) ?? "" }));
    if (before) parts.push(tr("First: {said}", { said: before.said }));
    if (why) parts.push(tr("Why: {said}", { said: why }));
    this.#entry.said = parts.filter(Boolean).join(" · ");
  }

  /** @returns {Promise<boolean>} whether the prediction is gone */
  async #forget() {
    try {
      await this.#keeping.forget(this.#entry);
      return true;
    } catch {
      this.complain(tr("This browser refuses to forget it."));
      return false;
    }
  }

  async #keep() {
    this.#entry.last = new Date().toISOString();
    await this.#keeping.put(this.#entry);
  }
}
