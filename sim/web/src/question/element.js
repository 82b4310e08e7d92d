/** `<carts-question>`: one question, saved at every input, marked where the page has the key. */

import { tr } from "../../../view/language.js";
import { isEmpty } from "../answers/entry.js";
import { need, say } from "../shared/dom.js";
import { atTheRun, changing, checked, tried, whenWatched } from "./beside-run.js";
import { showEarlier, showFirstIdea } from "./earlier.js";
import { Feedback } from "./feedback.js";
import { FORMS } from "./forms/kinds.js";
import { readOff } from "./forms/run.js";
import { wait } from "./gate.js";
import { plainText } from "./plain-text.js";
import { complain, complainSoon } from "./unread.js";

/**
 * What every kind of form offers. `said` is the answer in words; `recall` brings typed words back.
 * @typedef {{value: any, enable: (on: boolean) => void, said: () => string, recall?: (said: string, value: any) => void,
 *   problem?: () => string, marked?: (shown: string[]) => void, follow?: (book: import("../answers/book.js").Book) => void}} Form
 */

const NOT_SAVED = tr("Not saved");
const SOON = 400; // ms after which a page that still opens its store says so
const LATE = 4000; // ms after which a browser that has not kept an answer is said not to have
const ASKED = 300; // characters of the question that go with an answer

/** The element class for the page's answers. @param {import("../answers/book.js").Book} book */
export function questionElement(book) {
  return class CartsQuestion extends HTMLElement {
    /** @type {Form | null} */
    #form = null;
    /** @type {Feedback | null} */
    #feedback = null;
    /** @type {any} */
    #entry = null;
    #writes = 0;
    closed = false;
    #leaving = new AbortController(); // ends what the question hears of page and answers
    #ready = false; // what was answered before is back: until then no field takes a key

    connectedCallback() {
      this.#leaving = new AbortController();
      if (!this.#form) this.#adopt();
      if (this.#form) this.#listen(this.#leaving.signal);
    }

    disconnectedCallback() {
      this.#leaving.abort();
    }

    #adopt() {
      this.facts = JSON.parse(need(this, "script.carts-q-facts").textContent ?? "{}");
      this.formName = this.closest("carts-quiz")?.getAttribute("data-form") ?? "worksheet";
      const make = FORMS[this.facts.type];
      if (!make) return;
      this.#form = make(this, () => this.#changed(), this.facts);
      this.#entry = this.#fresh();
      for (const radio of this.#certainty()) {
        radio.addEventListener("change", () => this.#changed());
      }
      setTimeout(() => this.#ready || this.#say(tr("Opening your answers …")), SOON);
      if (this.facts.key)
        this.#feedback = new Feedback(
          this,
          () => this.#attempt(),
          (shown, verdict) => this.#marked(shown, verdict),
        );
      void book.ready.then(() => this.#restore());
    }

    /** @param {AbortSignal} signal */
    #listen(signal) {
      const elsewhere = (/** @type {any} */ { detail }) =>
        detail === book.key(this.formName ?? "worksheet", this.facts.id) && this.#show();
      book.addEventListener("elsewhere", elsewhere, { signal });
      book.addEventListener("change", () => this.#form?.follow?.(book), { signal });
      whenWatched(this, () => this.#ready && this.#keepAs(atTheRun(this.#entry)), signal);
      if (this.#ready) wait(this, signal); // put elsewhere in the page
    }

    /** Whether this question has an answer now. */
    get answered() {
      return !isEmpty(this.#form?.value);
    }

    /** Why this answer cannot be read; nothing where it can, or where there is none. */
    get unread() {
      return (this.answered && this.#form?.problem?.()) || "";
    }

    /** The answer as it stands. */
    get value() {
      return this.#form?.value ?? null;
    }

    /** No more changes: the form was handed in, or is over. @param {boolean} closed */
    close(closed) {
      this.closed = closed;
      this.#enable();
      need(this, ".carts-q-row").hidden = closed || !this.#feedback;
    }

    #enable() {
      const open = this.#ready && !this.closed;
      this.#form?.enable(open);
      for (const radio of this.#certainty()) radio.disabled = !open;
    }

    #fresh() {
      const { id, hash, type } = this.facts;
      return { id, hash, type, value: null, first: null, last: null, tries: 0 };
    }

    #certainty() {
      return /** @type {HTMLInputElement[]} */ ([...this.querySelectorAll(".carts-q-sure input")]);
    }

    #restore() {
      this.#say("");
      this.#show();
      this.#ready = true;
      this.#enable();
      this.dataset.ready = "";
      this.#form?.follow?.(book);
      wait(this, this.#leaving.signal);
    }

    /** Shows what is kept; an answer to another version of the question is shown beside it. */
    #show() {
      const found = book.get(this.formName ?? "worksheet", this.facts.id);
      if (!found || !this.#form) return;
      const current = found.hash === this.facts.hash && found.type === this.facts.type;
      const earlier = [
        ...(found.earlier ?? []),
        ...(current || isEmpty(found.value) ? [] : [found]),
      ];
      if (current) {
        this.#entry = found;
        if (this.#form.recall && typeof found.said === "string")
          this.#form.recall(found.said, found.value);
        else this.#form.value = found.value;
        for (const radio of this.#certainty()) radio.checked = radio.value === found.sure;
        this.#say(isEmpty(found.value) ? "" : this.#keptWord());
        const shown = found.judged && this.#feedback?.again(this.#tried());
        if (shown) this.#form.marked?.(shown);
        else this.#feedback?.stale();
      }
      this.#print();
      showEarlier(this, earlier, this.facts.hash);
    }

    #changed() {
      if (this.closed || !this.#ready) return;
      const now = new Date().toISOString();
      const sure = this.#certainty().find((radio) => radio.checked)?.value;
      const entry = {
        ...changing(this, this.#entry),
        judged: false,
        hash: this.facts.hash,
        value: this.#form?.value ?? null,
        said: this.#form?.said() ?? "",
        asked: plainText(need(this, ".carts-q-ask")).slice(0, ASKED),
        first: this.#entry.first ?? now,
        last: now,
      };
      if (this.facts.unit) entry.unit = this.facts.unit;
      const other = entry.value !== this.#entry.value;
      if (this.facts.type === "reading" && other) readOff(this.facts, entry);
      if (sure) entry.sure = sure;
      this.#entry = entry;
      void this.#keep(); // first of all
      this.#feedback?.stale();
      if (this.#feedback) complain(this, "");
      else complainSoon(this);
      this.#print();
      this.dispatchEvent(new CustomEvent("carts-answer", { bubbles: true }));
    }

    /** @param {any} entry */
    #keepAs(entry) {
      if (entry === this.#entry) return;
      this.#entry = entry;
      void this.#keep();
    }

    async #keep() {
      this.#writes += 1;
      const mine = this.#writes;
      this.#say(tr("Saving…"));
      const late = setTimeout(() => mine === this.#writes && this.#say(NOT_SAVED), LATE);
      try {
        await book.put(this.formName ?? "worksheet", this.#entry);
        if (mine === this.#writes) this.#say(this.#keptWord());
      } catch {
        this.#say(NOT_SAVED);
      } finally {
        clearTimeout(late);
      }
    }

    #keptWord() {
      return book.lasts ? tr("Saved") : NOT_SAVED;
    }

    /** One press on Check: what was answered, and the run that it was read off. */
    #attempt() {
      if (!this.answered || this.unread) {
        complain(this, this.unread || tr("Answer first."));
        return null;
      }
      if (this.facts.type === "reading") {
        if (this.#entry.own === undefined) this.#entry = readOff(this.facts, { ...this.#entry });
        if (this.#entry.own === undefined) {
          complain(this, tr("Run the scene first: lock your prediction there."));
          return null;
        }
      }
      this.#keepAs(tried(this.#entry));
      return this.#tried();
    }

    /** The answer as it was checked. */
    #tried() {
      const { own = null, tries = 0 } = this.#entry;
      return { value: this.#form?.value, own, tries };
    }

    /** @param {string[]} shown @param {string} verdict */
    #marked(shown, verdict) {
      this.#form?.marked?.(shown);
      this.#keepAs(checked(this.#entry, verdict));
    }

    /** The answer in words, for paper. */
    #print() {
      const said = this.#form?.said() ?? "";
      const free = ["short", "long", "number", "reading", "ordering"].includes(this.facts.type);
      say(need(this, ".carts-q-printed"), free ? said : "");
      this.toggleAttribute("data-answered", this.answered);
      const first = this.facts.idea && this.answered && book.get("worksheet", this.facts.idea);
      showFirstIdea(this, first || null);
    }

    /** @param {string} word */
    #say(word) {
      const place = need(this, ".carts-q-saved");
      say(place, word);
      place.classList.toggle("carts-q-unsaved", word === NOT_SAVED);
    }
  };
}
